#!/usr/bin/env python3
"""Measures every component of the forward in fixed games, and compares its slowest run with the declared budget.

The games are deterministic, so a run of a component does the same work in each repetition of a game. For every run the minimum time
over the repetitions counts, which removes interruptions by other programs. The slowest run, counted like this, must keep the declared
budget, and the slowest chain from sensing to acting the deadline. The maximum over all repetitions is printed too (`ever`), but is
not checked.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys

from budget import FIGURES, ROOT, executable, read

CORTEX = ROOT / "firmware/figures.txt"
HERE = "instructions of this machine, which executes {rate:.2f} for each ns of the forward's loop"
THERE = "instructions that the Cortex-M image executed in a game at 160x120, counted by QEMU (firmware/figures.txt)"


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", default="640x480", choices=["160x120", "320x240", "640x480"], help="size of the images")
    parser.add_argument("--repeats", type=int, default=5, help="repetitions of the games; three times as many while a check fails")
    parser.add_argument("--loop-ms", type=float, help="also fail if the chain takes longer in more than 1 of 100 cycles")
    parser.add_argument("--svg", type=pathlib.Path, help="also draw the bar chart of the documentation")
    parser.add_argument("--clock-mhz", type=float, help="clock of a slower processor, on which the chain must keep the deadline")
    parser.add_argument("--ipc", type=float, help="instructions that this processor executes per clock cycle")
    parser.add_argument("--firmware", action="store_true", help="for it, use the instructions of the Cortex-M image")
    chosen = parser.parse_args()
    if (chosen.clock_mhz is None) != (chosen.ipc is None) or chosen.firmware and not chosen.ipc:
        parser.error("an estimate needs --clock-mhz and --ipc")
    if chosen.repeats < 1 or any(value is not None and value <= 0 for value in (chosen.loop_ms, chosen.clock_mhz, chosen.ipc)):
        parser.error("the values must be above 0")
    return chosen


def quantile(sorted_times, part):
    """Nearest rank."""
    return sorted_times[max(math.ceil(part * len(sorted_times)), 1) - 1]


def row(name, minima, maximum, budget):
    """Times of a component or phase, µs; `times` is empty if it never ran."""
    times = sorted(time for time in minima if time is not None)
    found = {"name": name, "runs": len(times), "ever": maximum, "budget": budget}
    if times:
        found |= {"p50": quantile(times, 0.5), "p99": quantile(times, 0.99), "max": times[-1]}
    return found


def merge(repetitions):
    """Minimum of each run over the repetitions, and maximum of each channel, µs."""
    minima, maxima = [], [0.0] * len(repetitions[0][0])
    for cycles in zip(*repetitions, strict=True):
        for channel in range(len(maxima)):
            ran = [cycle[channel] for cycle in cycles if cycle[channel] is not None]
            if len(ran) not in (0, len(cycles)):
                raise SystemExit(f"the games are not deterministic: channel {channel} ran in one repetition and not in another")
            maxima[channel] = max([maxima[channel], *(time / 1e3 for time in ran)])
        minima.append([None if None in times else min(times) / 1e3 for times in zip(*cycles)])
    return minima, maxima


def rows_of(header, repetitions):
    minima, maxima = merge(repetitions)
    names = header["components"] + header["phases"]
    budgets = header["budgets_us"] + [None, None, header["chain_us"], header["chain_us"]]
    return [row(name, times, *rest) for name, times, *rest in zip(names, zip(*minima), maxima, budgets, strict=True)]


def findings(rows, deadline, loop_ms, estimate):
    """What exceeds a limit, and what was not measured."""
    chain = next(row for row in rows if row["name"] == "the whole chain")
    found = []
    for one in rows:
        if not one["runs"]:
            found.append(f"{one['name']} ran in none of the games: add a game in which it runs")
        elif one["budget"] is not None and one["max"] > one["budget"]:
            found.append(f"{one['name']} takes {one['max']:.1f} µs in its slowest run and declares {one['budget']} µs: "
                         "make it faster, or raise `budget_us`")
    slow = [("the slowest chain", chain.get("max", 0), deadline)]
    slow += [("the slowest of 100 chains", chain.get("p99", 0), 1e3 * loop_ms)] if loop_ms else []
    slow += [("the slowest chain on the slower processor", estimate[0][2], deadline)] if estimate else []
    return found + [f"{what} takes {1e-3 * took:.2f} ms, the limit is {1e-3 * limit:.2f} ms" for what, took, limit in slow if took > limit]


def estimate_of(chosen, header, rows):
    """Name, median and maximum on a slower processor, µs, the chain first; and an explanation."""
    if not chosen.ipc:
        return [], ""
    per_us = chosen.clock_mhz * chosen.ipc
    if chosen.firmware:
        lines = [line.split(" ") for line in CORTEX.read_text().splitlines() if not line.startswith("#")]
        return [(name, int(median) / per_us, int(most) / per_us) for name, median, most in lines], THERE
    rate = read(FIGURES.read_text())[f"forward.at_{chosen.size}"] / header["recording_s"] * 1e-6
    chain_first = sorted((one for one in rows if one["runs"]), key=lambda one: one["name"] != "the whole chain")
    return [(one["name"], one["p50"] * rate / per_us, one["max"] * rate / per_us) for one in chain_first], HERE.format(rate=rate * 1e-3)


def table(rows):
    print("µs for one run, the minimum over the repetitions\n")
    print(f"{'':<18}{'runs':>7}" + "".join(f"{name:>10}" for name in ("p50", "p99", "max", "ever", "declared", "headroom")))
    for one in rows:
        times = "".join(f"{one[name]:>10.2f}" for name in ("p50", "p99", "max", "ever")) if one["runs"] else f"{'':>40}"
        budget = "" if one["budget"] is None else f"{one['budget']:>10.2f}"
        headroom = f"{100 * (1 - one['max'] / one['budget']):>8.0f} %" if one["runs"] and budget else ""
        print(f"{one['name']:<18}{one['runs']:>7}{times}{budget}{headroom}")


WIDTH, LINE, TOP, LEFT, RIGHT = 860, 20, 62, 130, 700
GREEN, PALE, RED, GREY = "#2e6f40", "#8fc79f", "#c0392b", "#555555"
# Decades of the logarithmic axis: 10 ns to 1 s.
TICKS = dict(enumerate(["10 ns", "100 ns", "1 µs", "10 µs", "100 µs", "1 ms", "10 ms", "100 ms", "1 s"], -2))


def axis_x(us):
    return LEFT + (RIGHT - LEFT) * min(max((math.log10(us) + 2) / 8, 0), 1)


def text(x, y, words, more=""):
    return f'<text x="{x:.0f}" y="{y:.0f}"{more}>{words}</text>'


def rect(x, y, width, height, paint):
    return f'<rect x="{x}" y="{y}" width="{width:.1f}" height="{height}" {paint}/>'


def draw(rows, size, deadline):
    """Median, slowest run and declared budget of each component, on a logarithmic axis of time."""
    rows = [one for one in rows if one["runs"] and one["name"] not in ("sensing", "acting", "with an image")]
    bottom = TOP + LINE * len(rows)
    frame = f'stroke="{GREY}" fill="none"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {bottom + 12}" width="{WIDTH}" height="{bottom + 12}" '
        'font-family="Helvetica, Arial, sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        text(10, 20, f"One run of each component, {size.replace('x', '×')}", ' font-weight="bold"'),
        rect(300, 10, 16, 12, f'fill="{GREEN}"') + text(321, 20, "median"),
        rect(380, 10, 16, 12, f'fill="{PALE}"') + text(401, 20, "slowest run"),
        rect(488, 10, 16, 12, frame) + text(509, 20, "declared"),
        f'<path d="M578 9V23" stroke="{RED}" stroke-width="2"/>' + text(585, 20, f"deadline {1e-3 * deadline:.0f} ms"),
        text(WIDTH - 10, TOP - 9, "slowest / declared", ' text-anchor="end"'),
    ]
    for decade, label in TICKS.items():
        x = axis_x(10.0**decade)
        parts.append(f'<path d="M{x:.1f} {TOP}V{bottom}" stroke="#dddddd"/>')
        parts.append(text(x, TOP - 9, label, f' text-anchor="middle" fill="{GREY}"'))
    for place, one in enumerate(rows):
        y, budget = TOP + LINE * place, one["budget"]
        parts.append(text(LEFT - 8, y + 14, one["name"], ' text-anchor="end"'))
        slowest = RED if budget and one["max"] > budget else PALE
        for us, paint in ((one["max"], slowest), (one["p50"], GREEN)):
            parts.append(rect(LEFT, y + 4, axis_x(us) - LEFT, LINE - 8, f'fill="{paint}"'))
        if budget:
            parts.append(rect(LEFT, y + 2, axis_x(budget) - LEFT, LINE - 4, frame))
            parts.append(text(RIGHT + 12, y + 14, f"{one['max']:.3g} of {budget:.4g} µs"))
    x = axis_x(deadline)
    return "\n".join([*parts, f'<path d="M{x:.1f} {TOP}V{bottom}" stroke="{RED}" stroke-width="2"/>', "</svg>", ""])


def main():
    chosen = options()
    program, repetitions = executable("budget"), []
    while True:
        lines = subprocess.run([program, chosen.size], check=True, capture_output=True, text=True).stdout.splitlines()
        header = json.loads(lines[0])
        repetitions.append([json.loads(line) for line in lines[1:]])
        if len(repetitions) < chosen.repeats:
            continue
        # More repetitions can only lower the minimum times, so a failed check may be caused by interruptions.
        rows, deadline = rows_of(header, repetitions), 1e3 * header["deadline_ms"]
        estimate, how = estimate_of(chosen, header, rows)
        found = findings(rows, deadline, chosen.loop_ms, estimate)
        if not found or len(repetitions) >= 3 * chosen.repeats:
            break
    rows.sort(key=lambda one: -one.get("max", 0))
    table(rows)
    if estimate:
        print(f"\non {chosen.clock_mhz} MHz with {chosen.ipc} instructions per clock cycle, ms for one run; {how}\n")
        for name, median, most in estimate:
            print(f"{name:<18}{1e-3 * median:>10.3f}{1e-3 * most:>10.3f}")
    if chosen.svg:
        chosen.svg.write_text(draw(rows, chosen.size, deadline))
    sys.exit("\n".join(["", *found]) if found else None)


if __name__ == "__main__":
    main()
