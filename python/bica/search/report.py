"""Report of a search as one page without other files."""

from __future__ import annotations

import html
import io
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from optuna.trial import FrozenTrial, TrialState

from bica.parameters import Setting
from bica.search.comparison import Compared
from bica.search.study import Study

STYLE = """body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.2rem .8rem;border-bottom:1px solid #ccc;text-align:right}
td:first-child,th:first-child{text-align:left}td{white-space:nowrap}svg{max-width:100%;height:auto}"""


@dataclass(frozen=True)
class Results:
    """What a report shows."""

    study: Study
    trials: Sequence[FrozenTrial]
    importance: dict[str, float]
    #: Settings of the best candidate; empty if none met the constraints.
    best: dict[str, Setting]
    compared: Sequence[Compared]
    failed_games: Sequence[str]
    lost_blocks: Sequence[str]
    #: Lines about games, repetitions and times.
    facts: Sequence[str]


def write_report(path: Path, results: Results) -> None:
    """Write the page."""
    name = html.escape(results.study.name)
    parts = [
        f"<!doctype html><meta charset=utf-8><title>Search {name}</title><style>{STYLE}</style><h1>Search {name}</h1>",
        _list(results.facts),
        f"<h2>Best against default on {len(results.study.final_seeds)} held-out seeds</h2>",
        _comparison(results),
        "<h2>Parameters of the best</h2>",
        _parameters(results),
        f"<h2>History</h2>{_svg(lambda axes: _history(axes, results), (8, 4))}",
        f"<h2>Importance</h2>{_importance(results)}",
        "<h2>Slices</h2><p>Each point is a candidate; the line is the default.</p>",
        *(_slice(results, name) for name in results.study.parameters),
        "<h2>Games that failed in all tries</h2>",
        _list(results.failed_games or ["None."]),
        "<h2>Blocks that were lost and played again</h2>",
        _list(results.lost_blocks or ["None."]),
    ]
    path.write_text("\n".join(parts), encoding="utf-8")


def _list(lines: Iterable[str]) -> str:
    return "<ul>" + "".join(f"<li>{html.escape(line)}</li>" for line in lines) + "</ul>"


def _table(rows: Iterable[Sequence[str]]) -> str:
    first, *rest = rows
    head = "".join(f"<th>{html.escape(cell)}</th>" for cell in first)
    body = ("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in rest)
    return f"<table><tr>{head}</tr>{''.join(body)}</table>"


def _comparison(results: Results) -> str:
    if not results.compared:
        return "<p>No candidate met the constraints.</p>"
    rows = [("expression", "default", "95 %", "best", "95 %", "change", "95 %")]
    for each in results.compared:
        change = "" if each.change is None else f"{100 * each.change:+.1f} %"
        interval = "" if each.change_interval is None else _interval([100 * end for end in each.change_interval], " %")
        default, best = _interval(each.default_interval), _interval(each.best_interval)
        rows.append((each.text, f"{each.default:.4g}", default, f"{each.best:.4g}", best, change, interval))
    return _table(rows)


def _interval(ends: Sequence[float], unit: str = "") -> str:
    return f"{ends[0]:.4g} to {ends[1]:.4g}{unit}"


def _parameters(results: Results) -> str:
    if not results.best:
        return "<p>None.</p>"
    rows = [("parameter", "default", "best", "range", "unit")]
    for name, spread in results.study.parameters.items():
        described = results.study.described[name]
        limits = ", ".join(spread.variants) or f"{spread.minimum:g} to {spread.maximum:g}"
        rows.append((name, str(described.value), str(results.best[name]), limits, described.unit or ""))
    return _table(rows)


def _svg(draw: Callable[[Axes], None], size: tuple[float, float]) -> str:
    with mpl.rc_context({"svg.hashsalt": "bica", "svg.fonttype": "none"}):
        figure = Figure(figsize=size, layout="constrained")
        draw(figure.subplots())
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None})
    return text.getvalue()[text.getvalue().index("<svg") :]


def _value(trial: FrozenTrial) -> float:
    return float(trial.user_attrs["values"][0])


def _groups(results: Results) -> list[tuple[str, str, list[FrozenTrial]]]:
    """Return labels, colours and candidates: those that meet the constraints, those that violate them, those pruned."""
    judged = [trial for trial in results.trials if "values" in trial.user_attrs]
    full = [trial for trial in judged if trial.state == TrialState.COMPLETE]
    holds = [trial for trial in full if trial.user_attrs["violation"] <= 0]
    violates = [trial for trial in full if trial.user_attrs["violation"] > 0]
    pruned = [trial for trial in judged if trial.state == TrialState.PRUNED]
    return [("meets the constraints", "tab:blue", holds), ("violates", "tab:red", violates), ("pruned", "0.7", pruned)]


def _history(axes: Axes, results: Results) -> None:
    groups = _groups(results)
    for label, colour, trials in groups:
        axes.scatter([trial.number for trial in trials], [_value(trial) for trial in trials], s=14, c=colour, label=label)
    holds = sorted(groups[0][2], key=lambda trial: trial.number)
    least = [min(map(_value, holds[: index + 1])) for index in range(len(holds))]
    axes.step([trial.number for trial in holds], least, where="post", c="tab:blue")
    axes.set(xlabel="candidate", ylabel=results.study.objectives[0].text)
    axes.legend()


def _importance(results: Results) -> str:
    if not results.importance:
        return "<p>Too few candidates.</p>"
    items = sorted(results.importance.items(), key=lambda item: item[1])

    def draw(axes: Axes) -> None:
        axes.barh([name for name, _ in items], [share for _, share in items])
        axes.set(xlabel="share of the variance of the objective (PED-ANOVA)", xlim=(0, None))

    return _svg(draw, (8, 1 + 0.3 * len(items)))


def _slice(results: Results, name: str) -> str:
    def draw(axes: Axes) -> None:
        for _, colour, trials in _groups(results):
            values: list[Any] = [trial.params[name] for trial in trials]
            axes.scatter(values, [_value(trial) for trial in trials], s=14, c=colour)
        default = results.study.defaults[name]
        axes.axvline(str(default).lower() if isinstance(default, bool | str) else default, c="0.5", lw=1)  # type: ignore[arg-type]
        unit = results.study.described[name].unit
        axes.set(xlabel=f"{name}, {unit}" if unit else name, ylabel="objective")

    return _svg(draw, (4, 3))
