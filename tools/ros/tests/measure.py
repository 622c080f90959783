"""Processor time of each cycle of the robot's loop, without the node, with it, and with nodes that listen to all its topics.

Run it on an idle machine, in the environment of `cargo xtask ros`: `BICA_WALL_FOLLOWER=PROGRAM python measure.py [SECONDS]`.
The arguments after that replace the program's own, as `play --size 640x480`.
"""

import importlib
import multiprocessing
import os
import sys
import time
from itertools import pairwise
from pathlib import Path

from peer import SENSOR, Peer, Robot

PROGRAM = os.environ["BICA_WALL_FOLLOWER"]


def sample(process: int, seconds: float, costs: multiprocessing.Queue) -> None:
    """Puts the processor times of the loop's cycles, ns. The loop is the first thread that has the program's name, after `main`."""
    tasks = sorted(Path(f"/proc/{process}/task").iterdir(), key=lambda task: int(task.name))
    name = (tasks[0] / "comm").read_text()
    loop = next(task for task in tasks[1:] if (task / "comm").read_text() == name)
    asleep, end = [], time.monotonic() + seconds
    while time.monotonic() < end:
        # Between two cycles the loop sleeps, and its time stands still.
        if (loop / "stat").read_text().rsplit(")", 1)[1].split()[0] == "S":
            used = int((loop / "schedstat").read_text().split()[0])
            if not asleep or used != asleep[-1]:
                asleep.append(used)
        time.sleep(0.002)
    costs.put(sorted(after - before for before, after in pairwise(asleep)))


def message(kind: str) -> type:
    package, _, name = kind.split("/")
    return getattr(importlib.import_module(f"{package}.msg"), name)


def measure(nodes: int, seconds: float, arguments: list[str]) -> None:
    with Robot(PROGRAM, *arguments) as robot:
        peers = [Peer(f"measure_{index}") for index in range(nodes)]
        time.sleep(3.0)
        for peer in peers:
            peer.until(lambda peer=peer: len(peer.node.get_topic_names_and_types()) > 10, "the topics")
            for topic, [kind, *_] in peer.node.get_topic_names_and_types():
                if not kind.startswith("tf2_msgs"):
                    peer.listen(topic, message(kind), SENSOR)
        time.sleep(2.0)
        queue: multiprocessing.Queue = multiprocessing.get_context("spawn").Queue()
        sampler = multiprocessing.get_context("spawn").Process(target=sample, args=(robot.process.pid, seconds, queue))
        sampler.start()
        while sampler.is_alive():
            for peer in peers:
                peer.executor.spin_once(timeout_sec=0.0)
            time.sleep(0.001)
        costs = queue.get(timeout=1)
        got = [sum(map(len, peer.got.values())) for peer in peers]
        for peer in peers:
            peer.close()
        median, worst = (costs[int(part * len(costs))] * 1e-3 for part in (0.5, 0.99))
        print(f"{nodes} nodes: {len(costs)} cycles, median {median:.0f} µs, p99 {worst:.0f} µs; messages received: {got}")


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 20.0
    own = sys.argv[2:] or ["run"]
    measure(0, seconds, [*own, "--realtime"])
    for nodes in (0, 1, 10):
        measure(nodes, seconds, [*own, "--ros"])


if __name__ == "__main__":
    main()
