"""Series of games with one set of parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import closing

import pandas as pd

from bica.parameters import Setting
from bica.program import Program
from bica.search.blocks import Blocks
from bica.search.game import Task, blocks_of, candidate_of
from bica.search.spread import spread_to
from bica.search.store import Store

#: Most games of a block: a worker that is lost costs at most these.
MAX_BLOCK = 10


def play_series(
    program: Program,
    seeds: Iterable[int],
    world: str | None,
    settings: Mapping[str, Setting],
    arguments: Sequence[str] = (),
    timeout: float | None = None,
    *,
    address: str | None = None,
    workers: int | None = None,
    store: str = "sqlite://",
    report: Callable[[str], None] = lambda text: None,
) -> pd.DataFrame:
    """Play a game for each seed that the store does not have, and return all as a table in the order of the seeds."""
    seeds = sorted(set(seeds))
    program.params(settings)
    candidate = candidate_of(settings, tuple(arguments), program.digest)
    common = (candidate, str(program.path), program.digest, world, tuple(sorted(settings.items())), tuple(arguments))
    with closing(Store(store, f"series-{candidate}", report)) as games, closing(spread_to(address, workers)) as spread:
        blocks = Blocks(spread, games)
        size = max(1, min(MAX_BLOCK, len(seeds) // (4 * spread.slots)))
        tasks = [Task(*common, block, timeout) for block in blocks_of(seeds, size)]
        blocks.play_all(tasks, lambda played, wanted: report(f"{played} of {wanted} games"))
        wanted = set(seeds)
        rows = [game.row() for game in games.games(candidate) if game.seed in wanted and game.world == (world or "")]
        report(
            f"{len(rows)} games, {blocks.new_games} of them new, {blocks.repeated} tries repeated, "
            f"{len(games.lost())} blocks lost and played again; {100 * blocks.overhead:.1f} % of the time is not games"
        )
    return pd.DataFrame(rows)
