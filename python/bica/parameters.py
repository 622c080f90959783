"""Parameters of a robot's components."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

#: Value of a parameter.
Setting = bool | int | float | str


@dataclass(frozen=True)
class Parameter:
    """A parameter as its program describes it."""

    #: Name, `Component.name`.
    name: str
    doc: str
    #: Unit; None without one.
    unit: str | None
    #: `f32`, `i32`, `u32`, `bool` or `choice`.
    kind: str
    default: Setting
    value: Setting
    #: Where the value comes from, as "tune/nao.toml line 2"; None for the default.
    source: str | None
    #: Range of a number; None otherwise.
    minimum: float | None = None
    maximum: float | None = None
    step: float | None = None
    #: Values of a choice.
    variants: tuple[str, ...] = ()


def text(value: Setting) -> str:
    """Return a value as a command line has it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def assignments(settings: Mapping[str, Setting]) -> list[str]:
    """Return the options that set parameters, in the order of their names."""
    return [word for name in sorted(settings) for word in ("--set", f"{name}={text(settings[name])}")]


def parsed(kind: str, value: str) -> Setting:
    """Return the value of a text as the program prints it."""
    if kind == "bool":
        return value == "true"
    if kind == "f32":
        return float(value)
    return value if kind == "choice" else int(value)


def parameters_of(graph: Mapping[str, Any], report: Mapping[str, Any]) -> dict[str, Parameter]:
    """Join the ranges of `graph --json` and the values of `params --json`."""
    components = graph["components"]
    described = {f"{component['name']}.{param['name']}": param for component in components for param in component["params"]}
    rows = ((f"{row['component']}.{row['name']}", row) for row in report["parameters"])
    return {name: _parameter(name, row, described[name]) for name, row in rows}


def _parameter(name: str, row: Mapping[str, Any], described: Mapping[str, Any]) -> Parameter:
    kind = row["kind"]
    default, value = parsed(kind, row["default"]), parsed(kind, row["value"])
    least, most, step = (described.get(key) for key in ("min", "max", "step"))
    variants = tuple(variant["name"] for variant in described.get("variants", ()))
    return Parameter(name, row["doc"], row["unit"], kind, default, value, row["source"], least, most, step, variants)
