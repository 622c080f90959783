"""Runs, parameter search and recordings of robots made with BICA."""

from __future__ import annotations

import importlib
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from bica.parameters import Parameter, Setting
from bica.program import Program, ProgramError

if TYPE_CHECKING:
    from bica.recording import Recording
    from bica.search.series import series

__all__ = ["Parameter", "Program", "ProgramError", "Recording", "Setting", "params", "play", "series"]

#: What needs libraries that a worker of a search does not load.
_LAZY = {"Recording": "bica.recording", "series": "bica.search.series"}


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
    return Program.find(program).play(seed, world, set, arguments, timeout)


def params(
    set: Mapping[str, Setting] | None = None,  # noqa: A002
    *,
    program: Program | str | os.PathLike[str] | None = None,
    kind: str | None = None,
) -> dict[str, Parameter]:
    """Return the parameters of a program by their names `Component.name`, with ranges, units and values."""
    return Program.find(program).params(set, kind)


def __getattr__(name: str) -> Any:
    if name in _LAZY:
        return getattr(importlib.import_module(_LAZY[name]), name)
    raise AttributeError(f"module `bica` has no attribute `{name}`")
