"""The course of a search: candidates, their blocks of seeds, the comparison on held-out seeds."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field

from optuna.trial import Trial

from bica.parameters import assignments
from bica.program import ProgramError
from bica.search.blocks import Blocks
from bica.search.expression import ExpressionError, MissingValueError, columns_of
from bica.search.game import Game, Task
from bica.search.optimizer import Optimizer
from bica.search.study import Study


@dataclass
class Candidate:
    """A candidate that is being played."""

    trial: Trial
    #: Blocks that are not played yet.
    waiting: list[Task]
    #: Blocks of one step, in different worlds, that are being played.
    running: set[Task] = field(default_factory=set)
    games: list[Game] = field(default_factory=list)
    steps: int = 0


def check_columns(study: Study, blocks: Blocks) -> None:
    """Evaluate all expressions on the default with the first seed; raises ExpressionError if one can have no value on any games."""
    seed = study.search_seeds[0]
    tasks = study.tasks(study.defaults, (seed,))
    try:
        study.program.call(["params", *assignments(study.defaults)])
    except ProgramError:
        # Its candidate fails with this reason.
        return
    blocks.play_all(tasks, lambda played, wanted: None)
    played = [game.row() for game in blocks.store.games(tasks[0].candidate) if game.seed == seed and not game.error]
    for expression in study.expressions if played else ():
        with suppress(MissingValueError):
            # Twice: a value for each game has to be two values.
            expression.value(columns_of(played * 2))


class Search:
    """A search; it can be interrupted at any time and continued from its store."""

    def __init__(self, optimizer: Optimizer, blocks: Blocks, report: Callable[[str], None]) -> None:
        """Play the games of the optimizer's study in `blocks`."""
        self._study, self._optimizer, self._blocks, self._report = optimizer.study, optimizer, blocks, report
        # Equal candidates wait for the same games.
        self._playing: dict[Task, list[Candidate]] = {}
        self._candidates: list[Candidate] = []
        self._began = time.monotonic()
        self._ended_before = len(optimizer.ended())
        self._ended = self._ended_before

    def run(self) -> None:
        """Play until the study has its number of candidates."""
        self._fill()
        while self._candidates:
            for candidate in [each for each in self._candidates if not each.running]:
                self._advance(candidate)
            if self._playing:
                task, games = self._blocks.next()
                for candidate in self._playing.pop(task):
                    candidate.running.discard(task)
                    candidate.games += games
            self._fill()

    def _fill(self) -> None:
        """Begin candidates while there is room."""
        while len(self._candidates) < min(self._blocks.spread.slots, self._study.sampler.candidates - self._ended):
            trial = self._optimizer.ask()
            settings = self._optimizer.settings(trial)
            try:
                self._study.program.call(["params", *assignments(settings)])
            except ProgramError as error:
                self._fail(trial, str(error))
            else:
                self._candidates.append(Candidate(trial, self._study.tasks(settings, self._study.search_seeds)))

    def _fail(self, trial: Trial, why: str) -> None:
        self._optimizer.fail(trial, why)
        self._report(f"candidate {trial.number} fails: {why.splitlines()[0]}")
        self._ended += 1

    def _advance(self, candidate: Candidate) -> None:
        """Judge the games so far and play the next block in all worlds; or end the candidate."""
        if candidate.games and all(game.error for game in candidate.games):
            self._fail(candidate.trial, f"all games failed: {candidate.games[0].error}")
            self._candidates.remove(candidate)
            return
        if candidate.games:
            try:
                values, violations = self._judge(candidate.games)
            except ExpressionError as error:
                self._fail(candidate.trial, str(error))
                self._candidates.remove(candidate)
                return
            pruned = self._optimizer.report(candidate.trial, candidate.steps - 1, values, violations) and bool(candidate.waiting)
            if pruned or not candidate.waiting:
                self._optimizer.tell(candidate.trial, values, violations, pruned, len(candidate.games))
                self._candidates.remove(candidate)
                self._ended += 1
                self._progress(candidate, values, violations, pruned)
                return
        self._play_step(candidate)

    def _play_step(self, candidate: Candidate) -> None:
        count = len(self._study.worlds)
        step, candidate.waiting = candidate.waiting[:count], candidate.waiting[count:]
        candidate.steps += 1
        for task in step:
            rest = self._blocks.rest_of(task)
            known = self._blocks.store.games(task.candidate)
            candidate.games += [game for game in known if game.seed in task.seeds and game.world == (task.world or "")]
            if rest is None:
                continue
            if rest not in self._playing:
                self._blocks.submit(rest)
            self._playing.setdefault(rest, []).append(candidate)
            candidate.running.add(rest)

    def _judge(self, games: list[Game]) -> tuple[list[float], dict[str, float]]:
        columns = columns_of([game.row() for game in games])
        values = [expression.value(columns) for expression in self._study.objectives]
        violations = {each.text: each.violation(columns) for each in self._study.constraints}
        return values, violations

    def _progress(self, candidate: Candidate, values: list[float], violations: dict[str, float], pruned: bool) -> None:
        done, wanted = self._ended, self._study.sampler.candidates
        left = (time.monotonic() - self._began) / max(1, done - self._ended_before) * (wanted - done)
        worst = {name: f"{violation:g}" for name, violation in violations.items() if violation > 0}
        what = f"pruned after {len(candidate.games)} games" if pruned else f"{len(candidate.games)} games"
        shown = ", ".join(f"{value:.4g}" for value in values)
        self._report(
            f"[{done}/{wanted}, {left / 60:.0f} min left] candidate {candidate.trial.number}: {shown}, {what}"
            + (f", violates {worst}" if worst else "")
        )
