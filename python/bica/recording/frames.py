"""Tables of nested values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import pandas as pd

#: Name of the index of the frames: time since the start of the run's clock, s.
TIME = "time_s"
#: Type of a column by that of a schema. Whole numbers are exact, and a missing value changes no type; a missing float is NaN.
_TYPES = {
    "Bool": "boolean",
    **{f"{short}{bits}": f"{long}{bits}" for short, long in (("U", "UInt"), ("I", "Int")) for bits in (8, 16, 32, 64)},
    **{"Usize": "UInt64", "Isize": "Int64", "Char": "string", "String": "string"},
    **dict.fromkeys(("F32", "F64"), "float64"),
}


def flattened(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    """Return the parts of a value with their names: `name.field`, `name[0]`. A list of any length stays one value."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            yield from flattened(_field(name, key), part)
    elif isinstance(value, tuple):
        for index, part in enumerate(value):
            yield from flattened(f"{name}[{index}]", part)
    else:
        yield name, value


def _field(name: str, key: object) -> str:
    return f"{name}.{key}" if name else str(key)


def types(name: str, ty: Any) -> Iterator[tuple[str, str]]:
    """Return the columns of all values of a type of a schema, as `flattened` names them, with the types of pandas."""
    inner: Any
    kind, inner = next(iter(ty.items())) if isinstance(ty, dict) else (ty, None)
    match kind:
        case "Struct" | "StructVariant":
            parts = [(_field(name, field["name"]), field["ty"]["ty"]) for field in inner]
        case "Tuple" | "TupleStruct" | "TupleVariant":
            parts = [(f"{name}[{index}]", part["ty"]) for index, part in enumerate(inner)]
        case "NewtypeStruct" | "NewtypeVariant" | "Option":
            parts = [(name, inner["ty"])]
        case "Enum":
            # The name of a variant without content, or the content below the name.
            parts = [(_field(name, each["name"]), each["ty"]) for each in inner if each["ty"] != "UnitVariant"]
            if len(parts) < len(inner):
                yield name, "string"
        case _:
            yield name, _TYPES.get(kind, "object")
            return
    for part, of in parts:
        yield from types(part, of)


def frame(
    rows: Iterable[tuple[float, dict[str, Any]]],
    known: Mapping[str, str] | None = None,
    unit_of: Callable[[str], str | None] = lambda name: None,
) -> pd.DataFrame:
    """Return a table of rows with their times; its `attrs["units"]` has the units of the columns that have one.

    `known` are the columns of a schema with their types. Another column has such a type if its values are truth values or integers.
    """
    times, values = zip(*rows, strict=True) if (rows := list(rows)) else ((), ())
    known = known or {}
    names = dict.fromkeys([*known, *(name for row in values for name in row)])
    # A value that is missing as a whole has no parts, and so a column of its own.
    owners = {other[:at] for other in names for at, sign in enumerate(other) if sign in ".["}
    whole = {name for name in owners if name not in known and all(row.get(name) is None for row in values)}
    index = pd.Index(times, name=TIME, dtype=float)
    columns: dict[str, Any] = {
        name: _column([row.get(name) for row in values], known.get(name)) for name in names if name not in whole
    }
    table = pd.DataFrame({name: column.set_axis(index) for name, column in columns.items()}, index=index)
    table.attrs["units"] = {name: unit for name in columns if (unit := unit_of(name))}
    return table


def _column(values: list[Any], known: str | None) -> Any:
    kinds = {type(value) for value in values if value is not None}
    if known is None and kinds == {bool}:
        known = "boolean"
    elif known is None and kinds == {int}:
        numbers = [value for value in values if value is not None]
        known = "Int64" if max(numbers) < 2**63 and min(numbers) >= -(2**63) else "UInt64" if min(numbers) >= 0 else "object"
    column: Any = pd.Series(values, dtype="object" if known else None)
    return column.astype(known) if known else column
