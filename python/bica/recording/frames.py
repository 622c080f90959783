"""Tables of nested values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import pandas as pd

#: Name of the index of the frames: time since the start of the run's clock, s.
TIME = "time_s"


def flattened(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    """Return the parts of a value with their names: `name.field`, `name[0]`. A list of any length stays one value."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            yield from flattened(f"{name}.{key}" if name else str(key), part)
    elif isinstance(value, tuple):
        for index, part in enumerate(value):
            yield from flattened(f"{name}[{index}]", part)
    else:
        yield name, value


def frame(rows: Iterable[tuple[float, dict[str, Any]]], unit_of: Callable[[str], str | None] = lambda name: None) -> pd.DataFrame:
    """Return a table of rows with their times; its `attrs["units"]` has the units of the columns that have one."""
    times, values = zip(*rows, strict=True) if (rows := list(rows)) else ((), ())
    table = pd.DataFrame(list(values), index=pd.Index(times, name=TIME, dtype=float))
    # A value that is missing as a whole has no parts, and so a column of its own.
    whole = [name for name in map(str, table.columns) if any(str(other).startswith((f"{name}.", f"{name}[")) for other in table)]
    table = table.drop(columns=whole)
    table.attrs["units"] = {name: unit for name in map(str, table.columns) if (unit := unit_of(name))}
    return table
