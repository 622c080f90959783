#!/usr/bin/env python3
"""Measures the README's two commands in a fresh clone, and prints their slowest parts.

`python3 benches/scripts/newcomer.py [--judge]` clones the repository into target/newcomer, downloads the packages, then measures
`cargo run --release` and `cargo test --workspace`, the latter twice. With --judge it fails if a time is above its limit. Limits are
for two idle processors; on a busy machine, half of the time of all processors is a lower bound.
"""

import json
import re
import shutil
import sys

from waiting import ROOT, report, run

CLONE = ROOT / "target/newcomer"
LINES = 12


def slowest(title, rows):
    if not rows:
        sys.exit(f"no data: {title}")
    print(f"\n{title}:")
    for seconds, name in sorted(rows, reverse=True)[:LINES]:
        print(f"{seconds:>8.1f} s  {name}")


def compilations():
    """Time and name of each compilation of the last build with --timings."""
    report = (CLONE / "target/cargo-timings/cargo-timing.html").read_text()
    units = json.loads(re.search(r"const UNIT_DATA = (.*?);\n", report, re.DOTALL)[1])
    return [(unit["duration"], unit["name"] + unit["target"]) for unit in units]


def programs(log):
    """Time and name of each test program: a line names it, and a later line contains its time."""
    name, rows = None, []
    for line in map(str.strip, log.read_text().splitlines()):
        if line.startswith(("Running ", "Doc-tests ")):
            name = line
        if name and (time := re.search(r"; finished in ([0-9.]+)s$", line)):
            rows.append((float(time[1]), name))
    return rows


def main():
    judge = sys.argv[1:] == ["--judge"]
    if sys.argv[1:] and not judge:
        sys.exit(__doc__)
    shutil.rmtree(CLONE, ignore_errors=True)
    run("git", "clone", "--quiet", str(ROOT), str(CLONE))
    run("cargo", "fetch", "--quiet", "--locked", folder=CLONE)
    game = run("cargo", "run", "--release", "--timings", folder=CLONE)
    slowest("slowest parts of the release build", compilations())
    build = run("cargo", "test", "--workspace", "--no-run", "--timings", folder=CLONE)
    slowest("slowest parts of the test build", compilations())
    log = CLONE / "target/tests.log"
    with log.open("w") as file:
        first, again = (run("cargo", "test", "--workspace", folder=CLONE, output=file) for _ in range(2))
    slowest("slowest test programs", programs(log))
    clean = tuple(a + b for a, b in zip(build, first))
    late = report([
        ("first `cargo run --release`, to the end of the game", game, 60),
        ("first `cargo test --workspace`", clean, 300),
        ("second `cargo test --workspace`", again, 60),
    ])
    if judge and late:
        sys.exit("above its limit: " + "; ".join(late))


if __name__ == "__main__":
    main()
