"""The best candidate against the default on held-out seeds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bica.search.expression import Columns, Expression, ExpressionError, columns_of
from bica.search.game import Game

#: Number of resamples of the bootstrap.
RESAMPLES = 2000


@dataclass(frozen=True)
class Estimate:
    """A value with its 95 % confidence interval."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Compared:
    """An expression of both on the same seeds, with intervals of the bootstrap over seeds; None without a value."""

    text: str
    default: Estimate | None
    best: Estimate | None
    #: Difference relative to the default, %, negative if the best is less; None if the default is zero or the best one.
    change: Estimate | None


def compare(expressions: list[Expression], default: list[Game], best: list[Game]) -> list[Compared]:
    """Compare both on the seeds that both have played; seeds are resampled in pairs."""
    seeds = sorted({game.seed for game in default} & {game.seed for game in best})
    sides = [_columns(games, seeds) for games in (default, best)]
    draws = np.random.default_rng(0).integers(0, len(seeds), (RESAMPLES, len(seeds)))
    return [_compare(expression, sides, draws, default == best) for expression in expressions]


def _columns(games: list[Game], seeds: list[int]) -> Columns:
    """Return the columns with a row for each seed and, of several worlds, a further dimension."""
    worlds = sorted({game.world for game in games})
    by_place = {(game.seed, game.world): game.row() for game in games}
    flat = columns_of([by_place[seed, world] for seed in seeds for world in worlds])
    return {name: column.reshape(len(seeds), len(worlds)) for name, column in flat.items()}


def _compare(expression: Expression, sides: list[Columns], draws: np.ndarray, are_same: bool) -> Compared:
    def value(columns: Columns) -> float:
        try:
            return expression.value(columns)
        except ExpressionError:
            return np.nan

    resampled = ({name: column[draw] for name, column in columns.items()} for draw in draws for columns in sides)
    # The first row has the values themselves.
    default, best = np.array([value(columns) for columns in (*sides, *resampled)]).reshape(-1, 2).T
    with np.errstate(all="ignore"):
        change = 100 * (best - default) / np.abs(default)
    return Compared(expression.text, _estimate(default), _estimate(best), None if are_same else _estimate(change))


def _estimate(values: np.ndarray) -> Estimate | None:
    """Return the first value with the quantiles of the others; resamples without a value do not count."""
    some = values[np.isfinite(values)]
    if not np.isfinite(values[0]) or len(some) < 2:
        return None
    return Estimate(float(values[0]), *map(float, np.quantile(some[1:], [0.025, 0.975])))


def shown(compared: Compared) -> str:
    """Return a comparison as a line of text."""
    default, best = (f"{side.value:.4g}" if side else "without a value" for side in (compared.default, compared.best))
    line = f"{compared.text}: default {default}, best {best}"
    if (change := compared.change) is None:
        return line
    return f"{line}, change {change.value:+.1f} % (95 % interval {change.low:+.1f} to {change.high:+.1f} %)"
