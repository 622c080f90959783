"""Runs, parameter search and recordings of robots made with BICA."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from bica.parameters import Parameter, Setting
from bica.program import Program, ProgramError

if TYPE_CHECKING:
    import pandas as pd

    from bica.recording import Recording

__all__ = ["Parameter", "Program", "ProgramError", "Recording", "Setting", "params", "play", "series"]


def _program(program: Program | str | os.PathLike[str] | None) -> Program:
    return program if isinstance(program, Program) else Program.find(program)


def play(
    seed: int = 0,
    world: str | None = None,
    set: Mapping[str, Setting] | None = None,  # noqa: A002 - the name of the program's option
    *,
    program: Program | str | os.PathLike[str] | None = None,
    arguments: Sequence[str] = (),
    timeout: float | None = None,
) -> dict[str, Any]:
    """Play one game or run, and return its result as docs/json.md describes it.

    `set` maps names `Component.name` to values, `arguments` are further options of the program, `timeout` is in seconds. Raises
    ProgramError with the program's message.
    """
    return _program(program).play(seed, world, set, arguments, timeout)


def params(
    set: Mapping[str, Setting] | None = None,  # noqa: A002
    *,
    program: Program | str | os.PathLike[str] | None = None,
    kind: str | None = None,
) -> dict[str, Parameter]:
    """Return the parameters of a program by their names `Component.name`, with ranges, units and values."""
    return _program(program).params(set, kind)


def series(
    seeds: Iterable[int],
    world: str | None = None,
    set: Mapping[str, Setting] | None = None,  # noqa: A002
    *,
    program: Program | str | os.PathLike[str] | None = None,
    arguments: Sequence[str] = (),
    timeout: float | None = None,
    address: str | None = None,
    workers: int | None = None,
) -> pd.DataFrame:
    """Play a game for each seed and return a row for each, in the order of the seeds.

    `address` distributes the games: see docs/search.md. A game that failed has its message in the column `error`.
    """
    from bica.search.series import play_series

    return play_series(_program(program), seeds, world, set or {}, arguments, timeout, address=address, workers=workers)


def __getattr__(name: str) -> Any:
    # Recordings need a library of their own, which a search on a computer of a cluster does not load.
    if name == "Recording":
        from bica.recording import Recording

        return Recording
    raise AttributeError(f"module `bica` has no attribute `{name}`")
