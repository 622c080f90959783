#!/usr/bin/env python3
"""Repeats the tests that start programs, threads and sockets, beside other work.

Repeats `cargo test --workspace` beside busy processes, then the tests `sessions` of the monitor, then its tests in a browser. Stops at the
first failure and shows its output; prints how many runs of each have passed.
"""

import argparse
import multiprocessing
import subprocess
import sys
import time

from budget import ROOT


def series(name, command, runs, counts):
    """Runs a command several times, and notes how many runs passed. Raises SystemExit at the first failure."""
    counts.append([name, 0, runs])
    for run in range(1, runs + 1):
        began = time.monotonic()
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            raise SystemExit(f"{done.stdout}\n{name}, run {run} of {runs}: `{' '.join(command)}` failed")
        print(f"{name}: run {run} of {runs} passed in {time.monotonic() - began:.0f} s")
        counts[-1][1] = run


def spin():
    while True:
        pass


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--workspace", type=int, metavar="N", default=20, help="runs of `cargo test --workspace`")
    parser.add_argument("--busy", type=int, metavar="N", default=2, help="processes that compute beside these runs")
    parser.add_argument("--sessions", type=int, metavar="N", default=50, help="runs of the tests `sessions` of the monitor")
    parser.add_argument("--browser", type=int, metavar="N", default=10, help="runs of the tests of JManager's page in a browser")
    chosen = parser.parse_args()
    counts = []
    busy = [multiprocessing.Process(target=spin, daemon=True) for _ in range(chosen.busy)]
    try:
        for process in busy:
            process.start()
        series("cargo test --workspace", ["cargo", "test", "--quiet", "--workspace"], chosen.workspace, counts)
        for process in busy:
            process.terminate()
        series("sessions", ["cargo", "test", "--quiet", "--package", "bica-monitor", "--test", "monitor", "sessions::"], chosen.sessions, counts)
        series("browser", ["cargo", "xtask", "browser"], chosen.browser, counts)
    finally:
        for name, passed, runs in counts:
            print(f"{name}: {passed} of {runs} runs passed")


if __name__ == "__main__":
    sys.exit(main())
