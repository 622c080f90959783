"""Helpers of the measurements: a command with its wall-clock time, and processor time of it and of all its children."""

import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command, folder=ROOT, output=None):
    """Runs a command and returns (wall-clock time, processor time) in s; ends the program if it fails."""
    print("$", *command, file=sys.stderr, flush=True)
    environment = {name: value for name, value in os.environ.items() if name != "CARGO_TARGET_DIR"}
    before, began = os.times(), time.monotonic()
    code = subprocess.run(command, cwd=folder, env=environment, stdout=output, stderr=output).returncode
    wall, after = time.monotonic() - began, os.times()
    if code:
        sys.exit(f"`{' '.join(command)}` failed with exit code {code}")
    busy = after.children_user + after.children_system - before.children_user - before.children_system
    return wall, busy


def report(rows):
    """Prints rows of (name, (wall, busy), limit in s); returns the names of those whose both times are above the limit."""
    print(f"\n{'':<60}{'wall':>10}{'all processors':>16}{'limit':>10}")
    for name, (wall, busy), limit in rows:
        print(f"{name:<60}{wall:>8.1f} s{busy:>14.1f} s{limit:>8} s")
    return [name for name, spent, limit in rows if min(spent) > limit]
