#!/usr/bin/env python3
"""Compares the speed of the vision with OpenCV, on the same frames and the same core: `python3 benches/vision/compare.py`.

Installs OpenCV into target/opencv, measures both sides in turn, and prints a table of the minima. Fails unless OpenCV, which only
segments colours with the statistics of all regions, takes at least ten times as long as the whole vision in each row.
"""

import os
import pathlib
import subprocess
import sys
import venv

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "target/opencv"
PACKAGE = "opencv-python-headless"
# The sides alternate, so that other load on the machine affects both.
TURNS = 3
MIN_RATIO = 10
# Columns of the figures that each side prints: OpenCV without and with statistics of the regions.
COLUMNS = [("everything", "memcpy"), ("labels", "regions"), ("labels, threads", "regions, threads")]


def output(*command, cores=None):
    print("$", *command, file=sys.stderr, flush=True)
    pin = None if cores is None else lambda: os.sched_setaffinity(0, cores)
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True, preexec_fn=pin).stdout


def note(table, columns, text):
    """Keeps the minimum of each figure. A line has a set of frames with its size, and a figure for each column."""
    for line in text.splitlines():
        name, *words = line.split(" ")
        if "-" in name and "x" in name and len(words) >= len(columns):
            row = table.setdefault(name, {})
            for column, word in zip(columns, words):
                row[column] = min(float(word), row.get(column, float("inf")))


def main():
    python = FOLDER / "venv/bin/python"
    if not python.exists():
        venv.create(FOLDER / "venv", with_pip=True)
        output(str(python), "-m", "pip", "install", "--quiet", PACKAGE)
    bench = "cargo bench --quiet -p bica-bench --bench bica -- vision".split()
    frames = str(FOLDER / "frames")
    output(*bench, "export", frames)
    table = {}
    for _ in range(TURNS):
        note(table, COLUMNS[0], output(*bench, "everything", cores={0}))
        opencv = (str(python), "benches/vision/opencv.py", frames)
        note(table, COLUMNS[1], output(*opencv, cores={0}))
        note(table, COLUMNS[2], output(*opencv, "--threads"))
    heads = ["memcpy", "everything", "regions", "regions, threads", "labels", "labels, threads"]
    print(f"\nTime per frame, µs, minimum of {TURNS} turns\n{'':24}" + "".join(f"{head:>20}" for head in heads))
    for name, row in sorted(table.items()):
        cells = [f"{row[head]:.1f}" for head in heads[:2]]
        cells += [f"{row[head]:.0f} = {row[head] / row['everything']:.1f} ×" for head in heads[2:]]
        print(f"{name:24}" + "".join(f"{cell:>20}" for cell in cells))
    # The vision computes area, bounding box and centroid of each region, so the statistics are needed for equal work.
    ratio = min((row["regions"] / row["everything"] for row in table.values()), default=0)
    verdict = f"OpenCV with statistics takes at least {ratio:.1f} times as long as the vision; {MIN_RATIO} times is required"
    print(verdict) if ratio >= MIN_RATIO else sys.exit(verdict)


if __name__ == "__main__":
    main()
