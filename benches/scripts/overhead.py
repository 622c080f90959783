#!/usr/bin/env python3
"""Counts the instructions of the forward's tick beyond its steps: the cost of the framework.

Observes the program `overhead` by callgrind, which reports the instructions since its last report whenever a section of a component's
own code begins or ends.
"""

import pathlib
import subprocess
import tempfile

from budget import executable

VALGRIND = [
    "valgrind", "--quiet", "--tool=callgrind", "--combine-dumps=yes", "--collect-atstart=no", "--toggle-collect=*counted_*",
    "--dump-before=*section_begins*", "--dump-before=*section_ends*",
]


def outside(report):
    """The counts between a section's end and the next one's begin."""
    is_outside = True
    for line in report.splitlines():
        if line.startswith("desc: Trigger: "):
            is_outside = not line.endswith("section_ends")
        elif line.startswith("summary: ") and is_outside:
            yield int(line.removeprefix("summary: "))


def main():
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report")
        observe = [*VALGRIND, f"--callgrind-out-file={report}", executable("overhead")]
        printed = subprocess.run(observe, check=True, stdout=subprocess.PIPE, text=True).stdout
        counts = list(outside(report.read_text()))
    # Empty sections measure the cost of the probe's calls.
    empty, cycles = map(int, printed.split())
    call = sum(counts[:empty]) // empty
    sections = len(counts) - empty - 1
    if sections <= cycles:
        raise SystemExit(f"valgrind reported {sections} sections in {cycles} cycles")
    beyond = sum(counts[empty:]) - call * sections
    print(f"forward: {beyond // cycles} instructions beyond {sections // cycles} sections of steps in a tick")


if __name__ == "__main__":
    main()
