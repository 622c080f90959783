"""Plays blocks on whatever they are spread to, and stores each game once."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace

from bica.errors import BicaError
from bica.search.game import Game, Task
from bica.search.spread import Spread
from bica.search.store import Store

#: How often a block may be lost; a worker that dies more often dies because of it.
MAX_LOST = 5


class BlockError(BicaError):
    """A block was lost too often."""


class Blocks:
    """Blocks that are being played. Games that the store already has are not played again."""

    def __init__(self, spread: Spread, store: Store) -> None:
        """Play on `spread` and store in `store`."""
        self.spread, self.store = spread, store
        self.new_games, self.repeated, self._game_s = 0, 0, 0.0
        self._began = time.monotonic()
        self._lost = Counter[Task]()
        self.running = 0

    @property
    def overhead(self) -> float:
        """Share of the time of all slots that was not spent in games, 0 to 1."""
        available = self.elapsed_s * self.spread.slots
        return max(0.0, 1 - self._game_s / available) if available > 0 else 0.0

    @property
    def elapsed_s(self) -> float:
        """Time since the first block could be played, s."""
        return time.monotonic() - self._began

    def submit(self, task: Task) -> None:
        """Queue a block."""
        self.spread.submit(task)
        self.running += 1

    def next(self) -> tuple[Task, list[Game]]:
        """Wait for a block and store its games; a lost one is played again."""
        task, games = self.spread.next()
        while isinstance(games, str):
            self._again(task, games)
            task, games = self.spread.next()
        self.running -= 1
        self.new_games += self.store.add(games)
        self.repeated += sum(len(game.repeated) for game in games)
        self._game_s += sum(game.wall_s for game in games)
        return task, games

    def _again(self, task: Task, why: str) -> None:
        self._lost[task] += 1
        count = self._lost[task]
        seeds = f"seeds {task.seeds[0]} to {task.seeds[-1]} of {task.candidate}"
        if count == MAX_LOST:
            raise BlockError(f"{seeds} were lost {count} times: {why}")
        self.store.note_lost(f"{seeds} are played again, attempt {count + 1}: {why}")
        self.spread.submit(task)

    def play_all(self, tasks: Sequence[Task], progress: Callable[[int, int], None]) -> None:
        """Play all games of these blocks that the store does not have; `progress` gets the games played and wanted."""
        wanted = sum(len(task.seeds) for task in tasks)
        missing = [rest for task in tasks if (rest := self.rest_of(task)) is not None]
        played = wanted - sum(len(task.seeds) for task in missing)
        queue = iter(missing)
        for _, task in zip(range(2 * self.spread.slots), queue, strict=False):
            self.submit(task)
        while self.running:
            _, games = self.next()
            played += len(games)
            progress(played, wanted)
            for task in queue:
                self.submit(task)
                break

    def rest_of(self, task: Task) -> Task | None:
        """Return the part of a block that the store does not have; None if it has all."""
        known = {game.seed for game in self.store.games(task.candidate) if game.world == (task.world or "")}
        seeds = tuple(seed for seed in task.seeds if seed not in known)
        return replace(task, seeds=seeds) if seeds else None
