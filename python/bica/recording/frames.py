"""Tables of nested values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import pandas as pd

#: Name of the index of the frames: time since the start of the run's clock, s.
TIME = "time_s"


def flattened(name: str, value: Any, row: dict[str, Any]) -> None:
    """Add the parts of a value to a row: `name.field`, `name[0]`. A list of any length stays one value."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            flattened(f"{name}.{key}" if name else str(key), part, row)
    elif isinstance(value, tuple):
        for index, part in enumerate(value):
            flattened(f"{name}[{index}]", part, row)
    else:
        row[name] = value


def frame(times: Iterable[float], rows: list[dict[str, Any]], unit_of: Callable[[str], str | None]) -> pd.DataFrame:
    """Return a table with a row for each time; its `attrs["units"]` has the units of the columns that have one."""
    table = pd.DataFrame(rows, index=pd.Index(times, name=TIME, dtype=float))
    # A value that is missing as a whole has no parts, and so a column of its own.
    whole = [name for name in map(str, table.columns) if any(str(other).startswith((f"{name}.", f"{name}[")) for other in table)]
    table = table.drop(columns=whole)
    table.attrs["units"] = {name: unit for name in map(str, table.columns) if (unit := unit_of(name))}
    return table
