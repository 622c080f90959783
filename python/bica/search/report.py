"""Report of a search as one page without other files."""

from __future__ import annotations

import html
import io
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from functools import partial
from importlib.metadata import version
from pathlib import Path

import matplotlib as mpl
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from bica.parameters import Setting, text
from bica.search.comparison import Compared, Estimate
from bica.search.optimizer import Optimizer
from bica.search.store import PROCESSOR
from bica.search.study import Study

STYLE = """body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.2rem .8rem;border-bottom:1px solid #ccc;text-align:right}
td:first-child,th:first-child{text-align:left}td{white-space:nowrap}svg{max-width:100%;height:auto}"""


#: Groups of candidates and their colours.
COLOURS = {"meets the constraints": "tab:blue", "violates": "tab:red"}
#: What is said without a best candidate.
NOTHING = "no candidate has a value and meets the constraints"


PRUNED = "pruned, after fewer games"


def write_report(
    path: Path, optimizer: Optimizer, best: dict[str, Setting], compared: Sequence[Compared], facts: Sequence[str]
) -> None:
    """Write the page. `best` is empty if no candidate met the constraints, `facts` are lines about games and times."""
    study, store, trials = optimizer.study, optimizer.store, _judged(optimizer)
    name = html.escape(study.name)
    failed = [f"seed {game.seed} of {game.candidate}: {game.error}" for game in store.games() if game.error]
    processors = sorted({f"processor {kind}" for game in store.games() if (kind := game.values.get(PROCESSOR))})
    same = "<p>The best candidate is the default.</p>" if best == study.defaults else ""
    parts = [
        f"<!doctype html><meta charset=utf-8><title>Search {name}</title><style>{STYLE}</style><h1>Search {name}</h1>",
        _list([*_about(study), *processors, *facts]),
        f"<h2>Best against default on {len(study.final_seeds)} held-out seeds</h2>",
        same + _comparison(compared) if compared else f"<p>{NOTHING}</p>",
        "<h2>Parameters of the best</h2>",
        _parameters(study, best) if best else "<p>None.</p>",
        f"<h2>History</h2>{_svg(lambda axes: _history(axes, study, trials), (8, 4))}",
        f"<h2>Importance</h2>{_importance(optimizer.importance())}",
        "<h2>Slices</h2><p>Each point is a candidate, a mark below one that was pruned; the line is the default.</p>",
        *(_svg(partial(_slice, study=study, trials=trials, name=name), (4, 3)) for name in study.parameters),
        "<h2>Candidates</h2><p>A value of a pruned candidate is that of its games, which are fewer.</p>",
        _candidates(optimizer),
        "<h2>Games that failed in all tries</h2>",
        _list(failed or ["None."]),
        "<h2>Blocks that were lost and played again</h2>",
        _list(store.lost() or ["None."]),
    ]
    path.write_text("\n".join(parts), encoding="utf-8")


def _about(study: Study) -> list[str]:
    """Return what makes the search one that can be done again."""
    seeds = [f"{each[0]} to {each[-1]}" for each in (study.search_seeds, study.final_seeds)]
    worlds = ", ".join(world or "that of the program" for world in study.worlds)
    return [
        f"{datetime.now().astimezone():%Y-%m-%d %H:%M %z}, package {version('bica')}, study {study.fingerprint}",
        f"program {study.program.path} with the hash {study.program.digest}, arguments {' '.join(study.arguments) or 'none'}",
        f"seeds {seeds[0]} of the search, {seeds[1]} held out, sampler seed {study.sampler.seed}; world: {worlds}",
        *study.notes,
    ]


def _candidates(optimizer: Optimizer) -> str:
    study, rows = optimizer.study, []
    for trial in optimizer.ended():
        attributes, settings = trial.user_attrs, optimizer.settings(trial)
        values = attributes.get("values", [])
        state = attributes.get("refused") or ("pruned" if trial.state.name == "PRUNED" else "")
        cells = [f"{value:.4g}" for value in (*values, attributes["violation"])] if values else [""] * (len(study.objectives) + 1)
        rows.append(
            [str(trial.number), *map(text, settings.values()), str(attributes.get("games", "")), *cells, state.split("\n")[0]]
        )
    return _table(("number", *study.parameters, "games", *(each.text for each in study.objectives), "violation", ""), rows)


def _judged(optimizer: Optimizer) -> pd.DataFrame:
    """Return parameters, number, first objective and group of the candidates that have an objective."""
    rows = []
    for trial in optimizer.trials():
        if "values" in trial.user_attrs:
            is_pruned, violates = trial.state.name == "PRUNED", trial.user_attrs["violation"] > 0
            group = PRUNED if is_pruned else "violates" if violates else "meets the constraints"
            rows.append({**trial.params, "number": trial.number, "value": trial.user_attrs["values"][0], "group": group})
    return pd.DataFrame(rows, columns=[*optimizer.study.parameters, "number", "value", "group"])


def _list(lines: Iterable[str]) -> str:
    return "<ul>" + "".join(f"<li>{html.escape(line)}</li>" for line in lines) + "</ul>"


def _table(columns: Sequence[str], rows: list[list[str]]) -> str:
    return pd.DataFrame(rows, columns=list(columns)).to_html(index=False, border=0)


def _comparison(compared: Sequence[Compared]) -> str:
    def cells(estimate: Estimate | None, form: str, unit: str = "") -> list[str]:
        if estimate is None:
            return ["", ""]
        return [f"{estimate.value:{form}}{unit}", f"{estimate.low:.4g} to {estimate.high:.4g}{unit}"]

    rows = [[one.text, *cells(one.default, ".4g"), *cells(one.best, ".4g"), *cells(one.change, "+.1f", " %")] for one in compared]
    return _table(("expression", "default", "95 %", "best", "95 %", "change", "95 %"), rows)


def _parameters(study: Study, best: dict[str, Setting]) -> str:
    rows = []
    for name, spread in study.parameters.items():
        described = study.described[name]
        limits = ", ".join(spread.variants) or f"{spread.minimum:g} to {spread.maximum:g}"
        rows.append([name, text(described.value), text(best[name]), limits, described.unit or ""])
    return _table(("parameter", "default", "best", "range", "unit"), rows)


def _svg(draw: Callable[[Axes], None], size: tuple[float, float]) -> str:
    with mpl.rc_context({"svg.hashsalt": "bica", "svg.fonttype": "none"}):
        figure = Figure(figsize=size, layout="constrained")
        draw(figure.subplots())
        page = io.StringIO()
        figure.savefig(page, format="svg", metadata={"Date": None})
    return page.getvalue()[page.getvalue().index("<svg") :]


def _scatter(axes: Axes, trials: pd.DataFrame, x: str) -> None:
    """Draw the first objective of all candidates over a column."""
    for group, colour in COLOURS.items():
        some = trials[trials["group"] == group]
        axes.scatter(some[x], some["value"], s=14, c=colour, label=group)
    # Their values are of other seeds than those of the others.
    pruned = trials[trials["group"] == PRUNED][x]
    axes.scatter(pruned, [0.02] * len(pruned), s=40, c="0.6", marker="|", label=PRUNED, transform=axes.get_xaxis_transform())


def _history(axes: Axes, study: Study, trials: pd.DataFrame) -> None:
    _scatter(axes, trials, "number")
    meets = trials[trials["group"] == "meets the constraints"]
    axes.step(meets["number"], meets["value"].cummin(), where="post", c="tab:blue")
    axes.set(xlabel="candidate", ylabel=study.objectives[0].text)
    axes.legend()


def _importance(importance: dict[str, float]) -> str:
    if not importance:
        return "<p>Too few candidates.</p>"
    shares = pd.Series(importance).sort_values()

    def draw(axes: Axes) -> None:
        axes.barh(list(shares.index), shares)
        axes.set(xlabel="share of the variance of the objective (PED-ANOVA)", xlim=(0, None))

    return _svg(draw, (8, 1 + 0.3 * len(shares)))


def _slice(axes: Axes, study: Study, trials: pd.DataFrame, name: str) -> None:
    _scatter(axes, trials, name)
    default, unit = study.defaults[name], study.described[name].unit
    axes.axvline(text(default) if isinstance(default, bool | str) else default, c="0.5", lw=1)  # type: ignore[arg-type]
    axes.set(xlabel=f"{name}, {unit}" if unit else name, ylabel="objective")
