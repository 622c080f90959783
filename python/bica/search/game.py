"""Games of a block of seeds, as a worker plays them."""

from __future__ import annotations

import hashlib
import json
import socket
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from bica.parameters import Setting
from bica.program import Program, ProgramError, StoppedError

#: Tries of a game whose program crashes or takes too long.
TRIES = 3


@dataclass(frozen=True)
class Task:
    """A block of games of one candidate; all candidates play the same blocks."""

    #: Hash of the settings, world and arguments.
    candidate: str
    program: str
    #: Hash of the program's file.
    digest: str
    world: str | None
    settings: tuple[tuple[str, Setting], ...]
    arguments: tuple[str, ...]
    seeds: tuple[int, ...]
    #: Longest duration of a game, s; None without a limit.
    timeout: float | None = None


@dataclass(frozen=True)
class Game:
    """A game that was played, or that failed in all tries."""

    candidate: str
    world: str
    seed: int
    #: Values of the result that are no lists, `fingerprint` among them.
    values: dict[str, Any]
    #: Message of the last try; None if the game was played.
    error: str | None
    tries: int
    #: Messages of the tries that were repeated.
    repeated: list[str] = field(default_factory=list)
    #: Time of all tries, s.
    wall_s: float = 0.0
    host: str = ""

    def row(self) -> dict[str, Any]:
        """Return the game as a row of a table."""
        known = {"seed": self.seed, "world": self.world, "failed": self.error is not None}
        return {**self.values, **known, "error": self.error, "tries": self.tries, "wall_s": self.wall_s, "host": self.host}


def candidate_of(settings: Mapping[str, Setting], arguments: tuple[str, ...], digest: str) -> str:
    """Return a name for what determines the games of all seeds: settings, arguments and the program."""
    text = json.dumps([dict(sorted(settings.items())), arguments, digest])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def blocks_of(seeds: Sequence[int], size: int) -> list[tuple[int, ...]]:
    """Return the seeds in blocks of a size; the last may be smaller."""
    return [tuple(seeds[start : start + size]) for start in range(0, len(seeds), size)]


def play_block(task: Task) -> list[Game]:
    """Play the games of a block one after the other."""
    program = _program(task)
    return [_play(program, task, seed) for seed in task.seeds]


_checked: dict[str, Program] = {}


def _program(task: Task) -> Program:
    program = _checked.get(task.program)
    if program is None or program.digest != task.digest:
        program = Program(task.program)
        if program.digest != task.digest:
            raise ProgramError(f"`{task.program}` on {socket.gethostname()} is another build\n  help: copy the program there")
        _checked[task.program] = program
    return program


def _play(program: Program, task: Task, seed: int) -> Game:
    began, repeated = time.monotonic(), list[str]()
    while True:
        values: dict[str, Any] = {}
        try:
            result = program.play(seed, task.world, dict(task.settings), task.arguments, task.timeout)
            values, error = _values(result), None
        except ProgramError as failure:
            if failure.is_refusal or isinstance(failure, StoppedError):
                raise
            error = str(failure)
        tries = len(repeated) + 1
        if error is None or tries == TRIES:
            wall, host = time.monotonic() - began, socket.gethostname()
            return Game(task.candidate, task.world or "", seed, values, error, tries, repeated, wall, host)
        repeated.append(error)


def _values(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the single values of a result, with a fingerprint if it has none."""
    values = {
        name: value
        for name, value in result.items()
        if not isinstance(value, list | dict) and name not in ("schema", "seed", "world")
    }
    if "fingerprint" not in values:
        whole = {name: value for name, value in result.items() if not name.startswith("wall")}
        values["fingerprint"] = hashlib.sha256(json.dumps(whole, sort_keys=True).encode()).hexdigest()[:16]
    return values
