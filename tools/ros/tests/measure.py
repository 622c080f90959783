"""Processor time of the robot's loop in a cycle, without the node, with it, and with ten nodes that listen to all its topics.

Run it on an idle machine, in the environment of `cargo xtask ros`: `BICA_WALL_FOLLOWER=PROGRAM python measure.py [SECONDS]`.
The arguments after that replace the program's own, as `play --size 640x480`.
"""

import importlib
import os
import sys
import time
from pathlib import Path

from peer import SENSOR, Peer, Robot

PROGRAM = os.environ["BICA_WALL_FOLLOWER"]


def loop_time(process: int) -> int:
    """Processor time of the loop, ns: its thread is the first one that has the program's name, after that of `main`."""
    tasks = sorted(Path(f"/proc/{process}/task").iterdir(), key=lambda task: int(task.name))
    name = (tasks[0] / "comm").read_text()
    loop = next(task for task in tasks[1:] if (task / "comm").read_text() == name)
    return int((loop / "schedstat").read_text().split()[0])


def message(kind: str) -> type:
    package, _, name = kind.split("/")
    return getattr(importlib.import_module(f"{package}.msg"), name)


def measure(nodes: int, seconds: float, arguments: list[str]) -> float:
    with Robot(PROGRAM, *arguments) as robot:
        peers = [Peer(f"measure_{index}") for index in range(nodes)]
        time.sleep(3.0)
        for peer in peers:
            peer.until(lambda peer=peer: len(peer.node.get_topic_names_and_types()) > 10, "the topics")
            for topic, [kind, *_] in peer.node.get_topic_names_and_types():
                if not kind.startswith("tf2_msgs"):
                    peer.listen(topic, message(kind), SENSOR)
        time.sleep(2.0)
        begin = loop_time(robot.process.pid)
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for peer in peers:
                peer.executor.spin_once(timeout_sec=0.0)
            time.sleep(0.001)
        used = loop_time(robot.process.pid) - begin
        for peer in peers:
            peer.close()
        print(f"{nodes} nodes: {used / seconds * 1e-3:.0f} µs of processor time in a second")
        return used / seconds


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 20.0
    own = sys.argv[2:] or ["run"]
    measure(0, seconds, [*own, "--realtime"])
    for nodes in (0, 1, 10):
        measure(nodes, seconds, [*own, "--ros"])


main()
