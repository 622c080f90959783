"""The best candidate against the default on held-out seeds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bica.search.expression import Columns, Expression, columns_of
from bica.search.game import Game

#: Number of resamples of the bootstrap.
RESAMPLES = 2000


@dataclass(frozen=True)
class Compared:
    """An expression of both on the same seeds, with 95 % confidence intervals of the bootstrap over seeds."""

    text: str
    default: float
    best: float
    default_interval: tuple[float, float]
    best_interval: tuple[float, float]
    #: Difference relative to the default, negative if the best is less; None if the default is zero.
    change: float | None
    change_interval: tuple[float, float] | None


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
    default, best = (expression.value(columns) for columns in sides)
    samples = np.array([[expression.value(_drawn(columns, draw)) for columns in sides] for draw in draws])
    change, interval = None, None
    if default != 0 and np.all(samples[:, 0] != 0):
        change = (best - default) / abs(default)
        interval = _interval((samples[:, 1] - samples[:, 0]) / np.abs(samples[:, 0]))
    return Compared(expression.text, default, best, _interval(samples[:, 0]), _interval(samples[:, 1]), change, interval)


def _drawn(columns: Columns, draw: np.ndarray) -> Columns:
    return {name: column[draw] for name, column in columns.items()}


def _interval(samples: np.ndarray) -> tuple[float, float]:
    low, high = np.quantile(samples, [0.025, 0.975])
    return float(low), float(high)


def shown(compared: Compared) -> str:
    """Return a comparison as a line of text."""
    line = f"{compared.text}: default {compared.default:.4g}, best {compared.best:.4g}"
    if compared.change is None or compared.change_interval is None:
        return line
    low, high = compared.change_interval
    return f"{line}, change {100 * compared.change:+.1f} % (95 % interval {100 * low:+.1f} to {100 * high:+.1f} %)"
