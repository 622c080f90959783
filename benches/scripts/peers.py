#!/usr/bin/env python3
"""Measures the same workloads in BICA and other designs: time, heap allocations, program size. Checks the performance claims.

Exit status: 1 if a claim does not hold, or the measurement failed.
"""

import argparse
import os
import subprocess
import sys

from budget import ROOT

FOLDER = ROOT / "benches/peers"
PROGRAMS = ROOT / "target/peers/release"

DESIGNS = [
    "BICA", "BICA, timed", "copper-rs (always timed)", "copper-rs, clock mocked", "by hand", "by hand, inlined", "by hand, timed",
    "Box<dyn Component>", "Box<dyn Component>, timed", "blackboard, callbacks", "blackboard, channels", "statig", "smlang",
    "bonsai-bt",
]
BICA, TIMED, COPPER, _, BY_HAND, _, _, BOXED, _, CALLBACKS, CHANNELS, STATIG, SMLANG, BONSAI = DESIGNS
CHAIN_3, CHAIN_10, CHAIN_100, DIAMOND, MACHINE, FORWARD, SEQUENCE, FALLBACK = EMPTY = [
    "chain of 3", "chain of 10", "chain of 100", "diamond", "machine of 5", "tree of 25", "sequence of 10", "fallback of 10",
]
SIZED_CHAIN, SIZED_MACHINE, SIZED_FORWARD = SIZED = [f"{workload}, 20 ns" for workload in (CHAIN_10, MACHINE, FORWARD)]
TREE_10, TREE_100, ACTIVE, LATENT = GROWING = ["10 in a tree", "100 in a tree", "10 of 10 active", "10 of 100 active"]

# Programs whose sizes are compared, beside `size-empty`.
SIZES = {
    "size-bica": (BICA, CHAIN_10),
    "size-bica-machine": (BICA, MACHINE),
    "size-copper": (COPPER, CHAIN_10),
    "size-by-hand": (BY_HAND, CHAIN_10),
    "size-by-hand-machine": (BY_HAND, MACHINE),
    "size-boxed": (BOXED, CHAIN_10),
    "size-callbacks": (CALLBACKS, CHAIN_10),
    "size-channels": (CHANNELS, CHAIN_10),
    "size-statig": (STATIG, MACHINE),
    "size-smlang": (SMLANG, MACHINE),
    "size-bica-sequence": (BICA, SEQUENCE),
    "size-bonsai": (BONSAI, SEQUENCE),
}

# Least accepted time of boxed components, as a multiple of BICA's.
LEAST_BOXED = 1.3
# Largest accepted time of BICA, as a multiple of that of functions by hand and of state machines of others.
MOST_BY_HAND = 1.15


class Figures:
    """Minimum times of a cycle, ns; heap allocations per cycle; and program sizes beyond an empty program, bytes."""

    def __init__(self):
        self.times, self.heap, self.sizes = {}, {}, {}

    def record(self, design, workload, ns):
        case = (design, workload)
        self.times[case] = min(ns, self.times.get(case, ns))

    def ratio(self, more, less):
        """Ratio of the times of two cases; None if one was not measured."""
        if more in self.times and less in self.times:
            return self.times[more] / self.times[less]
        return None


def judge(figures):
    """Claims, what was found, and whether they hold. A claim about something that was not measured does not hold."""
    verdicts = []

    def compare(word, times, workload, more, less):
        ratio = figures.ratio((more, workload), (less, workload))
        holds = ratio is not None and (ratio >= times if word == "least" else ratio <= times)
        claim = f"{workload}: {more} takes at {word} {times} times as long as {less}"
        verdicts.append((claim, shown(ratio, f"{{:.{1 if word == 'least' else 2}f}} x"), holds))

    def within(ratio, tolerance, claim):
        found = shown(None if ratio is None else 100 * (ratio - 1), "{:+.1f} %")
        verdicts.append((f"{claim}, ±{100 * tolerance:.0f} %", found, ratio is not None and abs(ratio - 1) <= tolerance))

    compare("least", 8, CHAIN_10, COPPER, BICA)
    compare("least", 2, CHAIN_10, COPPER, TIMED)
    compare("least", 20, CHAIN_10, CALLBACKS, BICA)
    compare("least", 20, CHAIN_10, CHANNELS, BICA)
    compare("least", 4, SEQUENCE, BONSAI, BICA)
    compare("least", 10, FALLBACK, BONSAI, BICA)
    # In wide trees, as robots have them.
    ratio = figures.ratio((BICA, TREE_100), (BICA, TREE_10))
    within(ratio and ratio / 10, 0.15, "BICA: a component costs the same in a tree of 100 and in a tree of 10")
    # A lower cost does not violate the claim: the memory layout of the two trees differs.
    ratio = figures.ratio((BICA, LATENT), (BICA, ACTIVE))
    within(ratio and max(ratio, 1), 0.10, "BICA: 10 active components cost the same with and without 90 latent ones")
    most = max((count for (design, _), count in figures.heap.items() if design == BICA), default=None)
    verdicts.append(("BICA: no heap allocation in any workload", shown(most, "{:g} per cycle"), most == 0))
    for workload in (CHAIN_3, CHAIN_10, CHAIN_100, DIAMOND, FORWARD):
        compare("least", LEAST_BOXED, workload, BOXED, BICA)
        compare("most", MOST_BY_HAND, workload, BICA, BY_HAND)
    # A tick by itself takes as long as several empty steps, and the compiler folds them as it likes.
    compare("most", MOST_BY_HAND, SIZED_CHAIN, BICA, BY_HAND)
    compare("most", MOST_BY_HAND, SIZED_FORWARD, BICA, BY_HAND)
    for other in (BY_HAND, STATIG, SMLANG):
        compare("most", MOST_BY_HAND, SIZED_MACHINE, BICA, other)
    return verdicts


def shown(figure, form):
    return "not measured" if figure is None else form.format(figure)


def overhead(figures):
    """Time of a component beyond a function by hand, in each workload with steps of realistic size, ns. A component that is not due
    counts too."""
    for workload, count in ((SIZED_CHAIN, 10), (SIZED_MACHINE, 1), (SIZED_FORWARD, 25)):
        if figures.ratio((BICA, workload), (BY_HAND, workload)):
            beyond = (figures.times[BICA, workload] - figures.times[BY_HAND, workload]) / count
            yield f"BICA: {beyond:+.2f} ns per component beyond functions by hand ({workload})"


def short(figure):
    """Two or three significant digits."""
    return "0" if figure == 0 else f"{figure:.{2 if figure < 1 else 1 if figure < 100 else 0}f}"


def table(title, workloads, cells):
    """Markdown with a row for each design and a column for each workload; those without cells are left out."""
    columns = [workload for workload in workloads if any(at == workload for _, at in cells)]
    designs = [design for design in DESIGNS if any((design, workload) in cells for workload in columns)]
    rows = [[title, *columns]] + [[design] + [cells.get((design, workload), "") for workload in columns] for design in designs]
    widths = [max(len(row[at]) for row in rows) for at in range(len(columns) + 1)]
    rows.insert(1, ["-" * widths[0]] + ["-" * (width - 1) + ":" for width in widths[1:]])
    padded = ([row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])] for row in rows)
    return "".join(f"| {' | '.join(row)} |\n" for row in padded)


def times(figures, title, workloads):
    """Minimum times of a cycle and, in brackets, the ratio to BICA's time."""
    def cell(design, workload):
        ratio = None if design == BICA else figures.ratio((design, workload), (BICA, workload))
        return short(figures.times[design, workload]) + ("" if ratio is None else f" ({ratio:.2f} x)")
    return table(title, workloads, {case: cell(*case) for case in figures.times})


def tables(figures):
    yield times(figures, "ns per cycle (times BICA's)", EMPTY)
    yield times(figures, "steps of 20 ns: ns per cycle (times BICA's)", SIZED)
    yield times(figures, "steps of 20 ns: ns per cycle, as trees grow", GROWING)
    yield table("heap allocations per cycle", EMPTY, {case: short(count) for case, count in figures.heap.items()})
    yield table("KiB of program over an empty one", EMPTY, {case: f"{size / 1024:.1f}" for case, size in figures.sizes.items()})


def lines(program, *arguments):
    """Design, workload and number of each line that a program prints."""
    output = subprocess.run([PROGRAMS / program, *arguments], stdout=subprocess.PIPE, text=True, check=True).stdout
    for line in output.splitlines():
        design, workload, number = line.split("\t")
        if design not in DESIGNS or workload not in EMPTY + SIZED + GROWING:
            raise ValueError(f"`{line}`: this script lists no such design or workload")
        yield design, workload, float(number)


def pin():
    """Pins the processes to the last core that they may use, because interrupts are usually handled by the first."""
    try:
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    except (AttributeError, OSError):
        print("peers: this system cannot pin a process to one core; times will vary more", file=sys.stderr)


def measure(processes, rounds, slow):
    figures = Figures()
    pin()
    for process in range(1, processes + 1):
        print(f"peers: timing, process {process} of {processes}, {rounds} rounds", file=sys.stderr)
        for case in lines("peers", str(rounds), *["slow"] * slow):
            figures.record(*case)
    figures.heap = {(design, workload): count for design, workload, count in lines("peers-heap")}
    empty = (PROGRAMS / "size-empty").stat().st_size
    for program, case in SIZES.items():
        if (PROGRAMS / program).exists():
            figures.sizes[case] = (PROGRAMS / program).stat().st_size - empty
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="one process, few rounds: a preview, too short for reliable verdicts")
    parser.add_argument("--slow", action="store_true", help="like --quick, with a slowdown of BICA: every claim about time must fail")
    parser.add_argument("--without-copper", action="store_true", help="leave out copper-rs, which takes minutes to build")
    chosen = parser.parse_args()
    build = ["cargo", "build", "--release", "--locked", "--target-dir", ROOT / "target/peers"]
    # The first build takes minutes, so its progress is shown.
    subprocess.run(build + ["--features", "copper"] * (not chosen.without_copper), cwd=FOLDER, check=True)
    figures = measure(*((1, 100) if chosen.quick or chosen.slow else (5, 1500)), chosen.slow)
    print("\n".join(tables(figures)))
    print((FOLDER / "notes.md").read_text())
    # What was left out is not judged.
    verdicts = [verdict for verdict in judge(figures) if not (chosen.without_copper and COPPER in verdict[0])]
    for claim, found, holds in verdicts:
        print(f"{'pass' if holds else 'FAIL'}  {claim}: {found}")
    print("", *overhead(figures), sep="\n")
    return 0 if all(holds for _, _, holds in verdicts) else 1


if __name__ == "__main__":
    sys.exit(main())
