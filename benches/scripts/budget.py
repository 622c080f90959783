#!/usr/bin/env python3
"""Counts the instructions of the benchmarks with valgrind, and compares them with benches/instructions.txt.

    python3 benches/scripts/budget.py            fails unless each count is within 2 % of the committed one
    python3 benches/scripts/budget.py --bless    accepts the new counts
    python3 benches/scripts/budget.py --slow     counts with an artificial slowdown; fails unless every check fails

Counts depend neither on a clock nor on other programs on the machine. The checks have tests: benches/scripts/test_budget.py.
"""

import concurrent.futures
import json
import os
import pathlib
import platform
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ROOT / "benches/instructions.txt"
HEADING = "# Instructions, counted by valgrind. `python3 benches/scripts/budget.py --bless` writes this file."
# Largest accepted change of a count: relative, and absolute for small changes that come from code generation.
TOLERANCE, GRAIN = 0.02, 4
# Largest accepted ratio of a frame's instructions to those of a typical frame.
USUAL, MAX_RATIO = "vision.usual", 5.0
# The only benchmark of a tree without the slowdown, which is written by hand for comparison.
BY_HAND = "machine_by_hand.cycles"
# Without these features glibc uses its baseline functions for x86-64, so counts do not depend on the processor.
PLAIN = "glibc.cpu.hwcaps=-AVX2,-AVX512F,-AVX512VL,-ERMS,-FSRM,-AVX_Fast_Unaligned_Load,-BMI2,-SSE4_2,-SSSE3"
# Claims: `large` costs `times` as much as `small`, within `tolerance`; `without` is subtracted from both. Ten chains beside one have a
# larger tolerance: their root combines ten values, and the compiler folds the steps of one chain. Beside latent components the larger
# program has three calls that the compiler inlines in the smaller one. A tick costs something by itself, which does not grow.
ONE = "one.cycles"
CLAIMS = [
    # text, small, large, times, tolerance, without
    ("each further component costs the same up to a hundred in ten chains as up to ten",
     "ten.cycles", "a_hundred.cycles", 11, 0.30, ONE),
    ("each further component costs the same in a chain of a hundred as in a chain of ten",
     "chain_of_ten.cycles", "chain_of_a_hundred.cycles", 11, 0.10, ONE),
    ("ten robots of a hundred components in one process cost ten times one",
     "a_hundred.cycles", "ten_robots_of_a_hundred.cycles", 10, 0.10, None),
    ("a thousand components in a hundred trees cost a hundred times ten in one",
     "ten.cycles", "a_hundred_robots_of_ten.cycles", 100, 0.10, None),
    ("ten active components among ninety latent ones cost what they do alone",
     "ten_of_ten.cycles", "ten_of_a_hundred.cycles", 1, 0.15, None),
    ("a tree with parameters that is not tunable costs what it costs with constants",
     "constants.cycles", "tuned_off.cycles", 1, 0.005, None),
    ("the tunable forward costs what the forward with constants costs",
     "forward.at_160x120", "tunable_forward.at_160x120", 1, 0.03, None),
]


def changed(committed, counted):
    """A message for each count that changed, is new, or is missing."""
    wrong = []
    for name, now in sorted(counted.items()):
        before = committed.get(name)
        if before is None:
            wrong.append(f"{name}: new, {now} instructions")
        elif abs(now - before) > max(TOLERANCE * before, GRAIN):
            wrong.append(f"{name}: {before} instructions before, {now} now, {100 * (now / before - 1):+.2f} %")
    return wrong + [f"{name}: no longer counted" for name in sorted(committed) if name not in counted]


def hardest(counted):
    """A message for each frame that takes too many instructions."""
    if USUAL not in counted:
        return [f"{USUAL}: not counted"]
    ratios = {name: count / counted[USUAL] for name, count in sorted(counted.items()) if name.startswith("vision.")}
    return [f"{name}: {ratio:.1f} × a typical frame, at most {MAX_RATIO} × is allowed"
            for name, ratio in ratios.items() if ratio > MAX_RATIO]


def claims(counted):
    """For each claim whether it holds, and a line that says so."""
    found = []
    for text, small, large, times, tolerance, without in CLAIMS:
        needed = [name for name in (small, large, without) if name and name not in counted]
        if needed:
            found.append((False, f"FAIL  {text}: not counted: {', '.join(needed)}"))
            continue
        fixed = counted[without] if without else 0
        off = (counted[large] - fixed) / (times * (counted[small] - fixed)) - 1
        holds = abs(off) <= tolerance
        word = "pass" if holds else "FAIL"
        found.append((holds, f"{word}  {text}, ±{100 * tolerance:.1f} % of instructions: {100 * off:+.1f} %"))
    return found


def accepted_slow(committed, counted):
    """What the checks accept although it was slowed down; nothing may be."""
    frames = {name for name in counted if name.startswith("vision.") and name != USUAL}
    trees = {name for name in counted if name.endswith(".cycles") and name != BY_HAND}
    reported = [{line.split(":")[0] for line in lines} for lines in (hardest(counted), changed(committed, counted))]
    return (
        [f"{name}: not above the bound" for name in sorted(frames - reported[0])]
        + [f"{name}: not reported as changed" for name in sorted((frames | trees) - reported[1])]
        + [line for holds, line in claims(counted) if holds]
    )


def read(text):
    """Committed counts by name."""
    lines = [line.split(" ") for line in text.splitlines() if not line.startswith("#")]
    return {name: int(count) for name, count in lines}


def compiler():
    version = subprocess.run(["rustc", "--version"], check=True, capture_output=True, text=True, cwd=ROOT).stdout
    return f"# Compiler: {' '.join(version.split()[:2])} for {platform.machine()}"


def executable(bench, variables=None):
    """Builds a benchmark program, and returns its path."""
    command = ["cargo", "bench", "--profile", "dist", "--package", "bica-benches", "--bench", bench, "--no-run", "--message-format=json-render-diagnostics"]
    lines = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, cwd=ROOT, env=os.environ | (variables or {})).stdout
    paths = [message["executable"] for message in map(json.loads, lines.splitlines()) if message.get("executable")]
    return paths[-1]


def count(path, name):
    """Instructions of a benchmark."""
    valgrind = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*::case::counted*"]
    done = subprocess.run([*valgrind, path, name], capture_output=True, text=True, env=os.environ | {"GLIBC_TUNABLES": PLAIN})
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode or not found or found[1] == "0":
        raise SystemExit(f"{name}: not counted\n{done.stderr}")
    return int(found[1])


def count_all(slow):
    path = executable("instructions", {"BICA_SLOW": "1"} if slow else None)
    names = subprocess.run([path], check=True, capture_output=True, text=True).stdout.split()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(zip(names, pool.map(lambda name: count(path, name), names)))


def main():
    options = sys.argv[1:]
    if options not in ([], ["--bless"], ["--slow"]):
        sys.exit(__doc__)
    counted = count_all(options == ["--slow"])
    committed = read(FIGURES.read_text())
    if options == ["--slow"]:
        print("\n".join(hardest(counted) + changed(committed, counted) + [line for _, line in claims(counted)]))
        missed = accepted_slow(committed, counted)
        sys.exit("slowed down, but accepted:\n  " + "\n  ".join(missed) if missed else None)
    for name, now in sorted(counted.items()):
        change = f"{100 * (now / committed[name] - 1):+.2f} %" if name in committed else ""
        print(f"{name:<32}{now:>12}{change:>12}")
    found = claims(counted)
    print("\n".join(line for _, line in found))
    wrong = hardest(counted) + ["a claim does not hold"] * any(not holds for holds, _ in found)
    if options == ["--bless"] and not wrong:
        lines = [HEADING, compiler(), *(f"{name} {count}" for name, count in sorted(counted.items()))]
        FIGURES.write_text("\n".join(lines) + "\n")
        return
    differences = changed(committed, counted)
    if differences and compiler() not in FIGURES.read_text():
        differences.append(f"the compiler changed: {compiler()[2:]} now")
    if wrong or differences:
        remedy = "If the change is intended, run `python3 benches/scripts/budget.py --bless` and give the reason in the commit."
        sys.exit("\n  ".join(["wrong:", *wrong, *differences]) + "\n" + remedy)


if __name__ == "__main__":
    main()
