#!/usr/bin/env python3
"""Measures the README's first two commands in fresh clones, of this commit and of an older one.

`python3 benches/scripts/newcomer.py [--against COMMIT] [--judge]` clones the repository into target/newcomer, downloads the packages,
and measures `cargo run --release` and `cargo test --workspace`, the latter twice. Processor time counts (user and system, of all
processes): it hardly depends on what else the machine does. With --judge it fails above a limit: GAME s for the first game, TESTS of the
older commit's time for the first tests, and a minute for the second ones.
"""

import argparse
import json
import re
import shutil
import sys

from waiting import ROOT, run

FOLDER = ROOT / "target/newcomer"
GAME, TESTS, AGAIN = 110, 0.55, 60
LINES = 12


def slowest(title, rows):
    if not rows:
        sys.exit(f"no data: {title}")
    print(f"\n{title}:")
    for seconds, name in sorted(rows, reverse=True)[:LINES]:
        print(f"{seconds:>8.1f} s  {name}")


class Clone:
    """A clone of a commit, with an empty build directory and all packages downloaded."""

    def __init__(self, name, commit):
        self.name, self.folder, self.rows = name, FOLDER / name, []
        run("git", "clone", "--quiet", str(ROOT), str(self.folder))
        run("git", "checkout", "--quiet", commit, folder=self.folder)
        run("cargo", "fetch", "--quiet", "--locked", folder=self.folder)

    def build(self, name, *command):
        """Measures a command that compiles; prints its slowest parts."""
        wall, busy = run(*command, "--timings", folder=self.folder)
        report = (self.folder / "target/cargo-timings/cargo-timing.html").read_text()
        units = json.loads(re.search(r"const UNIT_DATA = (.*?);\n", report, re.DOTALL)[1])
        slowest(f"{self.name}: slowest parts of {name}", [(unit["duration"], unit["name"] + unit["target"]) for unit in units])
        self.rows.append((name, wall, busy, len({(unit["name"], unit["version"]) for unit in units})))

    def test(self, name):
        log = self.folder / "target/tests.log"
        with log.open("w") as file:
            self.rows.append((name, *run("cargo", "test", "--workspace", folder=self.folder, output=file), 0))
        slowest(f"{self.name}: slowest test programs", programs(log))

    def time(self, *names):
        return sum(busy for name, _, busy, _ in self.rows if name in names)


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
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--against", metavar="COMMIT")
    parser.add_argument("--judge", action="store_true")
    options = parser.parse_args()
    shutil.rmtree(FOLDER, ignore_errors=True)
    clones = [Clone("this", "HEAD")] + ([Clone("older", options.against)] if options.against else [])
    for clone in clones:
        clone.build("first game", "cargo", "run", "--release")
    for clone in clones:
        clone.build("build of the tests", "cargo", "test", "--workspace", "--no-run")
        clone.test("first tests")
        clone.test("second tests")
    print(f"\n{'':<28}{'wall':>10}{'processors':>14}{'packages':>10}")
    for clone in clones:
        for name, wall, busy, packages in clone.rows:
            print(f"{clone.name + ': ' + name:<28}{wall:>8.1f} s{busy:>12.1f} s{packages or '':>10}")
    this, older = clones[0], clones[-1]
    late = [f"the first game takes {this.time('first game'):.0f} s, at most {GAME}"] if this.time("first game") > GAME else []
    ratio = this.time("build of the tests", "first tests") / older.time("build of the tests", "first tests")
    print(f"\nfirst `cargo test --workspace`: {100 * ratio:.0f} % of the older commit's" if options.against else "")
    if options.against and ratio > TESTS:
        late.append(f"the first tests take {100 * ratio:.0f} % of the older commit's time, at most {100 * TESTS:.0f} %")
    if min(wall_and_busy := this.rows[-1][1:3]) > AGAIN:
        late.append(f"the second tests take {wall_and_busy[0]:.0f} s, at most {AGAIN}")
    if options.judge and late:
        sys.exit("above its limit: " + "; ".join(late))


if __name__ == "__main__":
    main()
