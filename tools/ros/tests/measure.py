"""Processor time of the cycles of the forward's loop without the node, with it, and with nodes that listen to it.

`python measure.py PROGRAM [WINDOWS]` in the environment of `cargo xtask ros`. The program is the example `link_cost`, which has the
same loop without a node beside it, and prints a line for each window of 15 s. The nodes share the lowest priority: on another computer
they would take nothing from the robot.
"""

import importlib
import multiprocessing
import os
import re
import statistics
import subprocess
import sys
import time
from multiprocessing.connection import Connection

from peer import SENSOR, Peer


def message(kind: str) -> type:
    package, _, name = kind.split("/")
    return getattr(importlib.import_module(f"{package}.msg"), name)


def listen(nodes: int, own: bool, pipe: Connection) -> None:
    """Listens to the topics with standard names, and with `own` to all, until something comes through the pipe.

    Then it sends the number of bytes that each node has taken.
    """
    os.nice(19)
    peers, taken = [Peer(f"measure_{index}") for index in range(nodes)], [0] * nodes
    for index, peer in enumerate(peers):

        def take(data: bytes, index: int = index) -> None:
            taken[index] += len(data)

        peer.until(lambda peer=peer: len(peer.node.get_topic_names_and_types()) > 10, "the topics", 120)
        for topic, [kind, *_] in peer.node.get_topic_names_and_types():
            # The environment does not have the package `tf2_msgs`.
            if kind.startswith("tf2_msgs") or (topic.startswith("/forward/") and not own):
                continue
            peer.node.create_subscription(message(kind), topic, take, SENSOR, raw=True)
    time.sleep(5.0)
    pipe.send(None)
    while not pipe.poll():
        for peer in peers:
            peer.executor.spin_once(timeout_sec=0.0)
        time.sleep(0.001)
    pipe.send(taken)


def windows(program: str, nodes: int, own: bool, count: int) -> None:
    """Prints the medians over some windows."""
    here, there = multiprocessing.Pipe()
    robot = subprocess.Popen([program, "--ros"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    listener = multiprocessing.get_context("spawn").Process(target=listen, args=(nodes, own, there))
    if nodes:
        listener.start()
        here.recv()
    lines = (line for line in robot.stdout if line.startswith("without"))
    # Nodes came in the middle of the first window.
    found = [[float(value) for value in re.findall(r"(?:median|p99) ([\d.]+)", next(lines))] for _ in range(count + 1)][1:]
    robot.stdin.close()
    if nodes:
        here.send(None)
        print("  MB taken by each:", *(round(size * 1e-6) for size in here.recv()))
        listener.join()
    robot.wait(60)
    median, worst, with_median, with_worst = map(statistics.median, zip(*found, strict=True))
    topics = "all topics" if own else "standard topics"
    print(f"{nodes} nodes, {topics}: median and p99 without {median:.3f} and {worst:.3f} ms,", end=" ")
    print(f"with {with_median:.3f} and {with_worst:.3f} ms; windows {found}", flush=True)


def main() -> None:
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5
    for nodes, own in ((0, False), (1, False), (10, False), (1, True), (10, True)):
        windows(program, nodes, own, count)


if __name__ == "__main__":
    main()
