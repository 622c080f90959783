"""Series of games with one set of parameters."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import closing

import pandas as pd

from bica.parameters import Setting
from bica.program import Program
from bica.search.blocks import Blocks
from bica.search.game import candidate_of, tasks_of
from bica.search.spread import spread_to
from bica.search.store import Store

#: Most games of a block: a worker that is lost costs at most these.
MAX_BLOCK = 10


def series(
    seeds: Iterable[int],
    world: str | None = None,
    set: Mapping[str, Setting] | None = None,  # noqa: A002 - the name of the program's option
    *,
    program: Program | str | os.PathLike[str] | None = None,
    arguments: Sequence[str] = (),
    timeout: float | None = None,
    address: str | None = None,
    workers: int | None = None,
    store: str = "sqlite://",
    report: Callable[[str], None] = lambda text: None,
) -> pd.DataFrame:
    """Play a game for each seed that the store does not have, and return a row for each, in the order of the seeds.

    `address` distributes the games: see docs/search.md. A game that failed has its message in the column `error`.
    """
    program, settings = Program.find(program), set or {}
    wanted = frozenset(seeds)
    program.params(settings)
    name = candidate_of(program, settings, arguments)
    with closing(Store(store, f"series-{name}", report)) as games, closing(spread_to(address, workers)) as spread:
        blocks = Blocks(spread, games)
        size = max(1, min(MAX_BLOCK, len(wanted) // (4 * spread.slots)))
        tasks = tasks_of(program, settings, sorted(wanted), size, [world], arguments, timeout)
        blocks.play_all(tasks, lambda played, count: report(f"{played} of {count} games"))
        rows = [game.row() for game in games.games(name) if game.seed in wanted and game.world == (world or "")]
        report(
            f"{len(rows)} games, {blocks.new_games} of them new, {blocks.repeated} tries repeated, "
            f"{len(games.lost())} blocks lost and played again; {100 * blocks.overhead:.1f} % of the time is not games"
        )
    return pd.DataFrame(rows)
