"""Games of a block of seeds, as a worker plays them."""

from __future__ import annotations

import hashlib
import json
import socket
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
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


def candidate_of(program: Program, settings: Mapping[str, Setting], arguments: Sequence[str]) -> str:
    """Return a name for what determines the games of all seeds."""
    text = json.dumps([dict(sorted(settings.items())), arguments, program.digest])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def tasks_of(
    program: Program,
    settings: Mapping[str, Setting],
    seeds: Sequence[int],
    size: int,
    worlds: Sequence[str | None] = (None,),
    arguments: Sequence[str] = (),
    timeout: float | None = None,
) -> list[Task]:
    """Return the games of a candidate: for each `size` seeds a block in each world; the last blocks may be smaller."""
    common = (candidate_of(program, settings, arguments), str(program.path), program.digest)
    values, words = tuple(sorted(settings.items())), tuple(arguments)
    blocks = [tuple(seeds[start : start + size]) for start in range(0, len(seeds), size)]
    return [Task(*common, world, values, words, block, timeout) for block in blocks for world in worlds]


def play_block(task: Task) -> list[Game]:
    """Play the games of a block one after the other."""
    program = _program(task.program, task.digest)
    return [_play(program, task, seed) for seed in task.seeds]


@lru_cache(maxsize=4)
def _program(path: str, digest: str) -> Program:
    program = Program(path)
    if program.digest != digest:
        raise ProgramError(f"`{path}` on {socket.gethostname()} is another build\n  help: copy the program there")
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
    """Return the single values of a result and its figures, with a fingerprint if it has none."""
    known = ("schema", "seed", "world")
    figures = {figure["name"]: figure["value"] for figure in result.get("figures", [])}
    values = figures | {name: value for name, value in result.items() if name not in known and not isinstance(value, list | dict)}
    if "fingerprint" not in values:
        whole = {name: value for name, value in result.items() if not name.startswith("wall")}
        values["fingerprint"] = hashlib.sha256(json.dumps(whole, sort_keys=True).encode()).hexdigest()[:16]
    return values
