"""The best candidate against the default on held-out seeds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bica.search.expression import Columns, Expression, columns_of
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
    """An expression of both on the same seeds, with intervals of the bootstrap over seeds."""

    text: str
    default: Estimate
    best: Estimate
    #: Difference relative to the default, %, negative if the best is less; None if the default is zero.
    change: Estimate | None


def compare(expressions: list[Expression], default: list[Game], best: list[Game]) -> list[Compared]:
    """Compare both on the seeds that both have played; seeds are resampled in pairs."""
    seeds = sorted({game.seed for game in default} & {game.seed for game in best})
    sides = [_columns(games, seeds) for games in (default, best)]
    draws = np.random.default_rng(0).integers(0, len(seeds), (RESAMPLES, len(seeds)))
    return [_compare(expression, sides, draws) for expression in expressions]


def _columns(games: list[Game], seeds: list[int]) -> Columns:
    """Return the columns with a row for each seed and, of several worlds, a further dimension."""
    worlds = sorted({game.world for game in games})
    by_place = {(game.seed, game.world): game.row() for game in games}
    flat = columns_of([by_place[seed, world] for seed in seeds for world in worlds])
    return {name: column.reshape(len(seeds), len(worlds)) for name, column in flat.items()}


def _compare(expression: Expression, sides: list[Columns], draws: np.ndarray) -> Compared:
    def value(columns: Columns, draw: np.ndarray) -> float:
        return expression.value({name: column[draw] for name, column in columns.items()})

    samples = [[value(columns, draw) for columns in sides] for draw in draws]
    # The first row has the values themselves.
    default, best = np.array([[expression.value(columns) for columns in sides], *samples]).T
    change = _estimate(100 * (best - default) / np.abs(default)) if np.all(default != 0) else None
    return Compared(expression.text, _estimate(default), _estimate(best), change)


def _estimate(values: np.ndarray) -> Estimate:
    return Estimate(float(values[0]), *map(float, np.quantile(values[1:], [0.025, 0.975])))


def shown(compared: Compared) -> str:
    """Return a comparison as a line of text."""
    line = f"{compared.text}: default {compared.default.value:.4g}, best {compared.best.value:.4g}"
    if (change := compared.change) is None:
        return line
    return f"{line}, change {change.value:+.1f} % (95 % interval {change.low:+.1f} to {change.high:+.1f} %)"
