"""Study files: what a search varies, plays and minimises."""

from __future__ import annotations

import hashlib
import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from bica.errors import BicaError
from bica.parameters import Parameter
from bica.program import Program
from bica.search.expression import Constraint, Expression, ExpressionError

T = TypeVar("T")

SAMPLERS = ("tpe", "cma-es", "nsga-ii", "random")


class StudyError(BicaError):
    """A study file is wrong."""


@dataclass(frozen=True)
class Range:
    """Range of a searched parameter; a choice has `variants` instead."""

    kind: str
    minimum: float = 0.0
    maximum: float = 0.0
    log: bool = False
    variants: tuple[str, ...] = ()


@dataclass(frozen=True)
class Study:
    """A study file, checked against the program."""

    name: str
    program: Program
    parameters: dict[str, Range]
    worlds: tuple[str | None, ...]
    search_seeds: tuple[int, ...]
    final_seeds: tuple[int, ...]
    block: int
    objectives: tuple[Expression, ...]
    constraints: tuple[Constraint, ...]
    #: Further expressions that the report gives for the best and the default.
    reported: tuple[Expression, ...]
    sampler: str
    sampler_seed: int
    candidates: int
    #: Number of blocks before a candidate may be pruned; None without pruning.
    prune_after: int | None
    arguments: tuple[str, ...] = ()
    timeout: float | None = None
    described: dict[str, Parameter] = field(default_factory=dict)

    @property
    def defaults(self) -> dict[str, Any]:
        """Values of the searched parameters without a search, within the ranges."""
        return {name: _clamped(self.described[name].value, spread) for name, spread in self.parameters.items()}

    @property
    def fingerprint(self) -> str:
        """Hash of what makes the values of candidates comparable; the number of candidates is not part of it."""
        objective = [[each.text for each in self.objectives], [each.text for each in self.constraints]]
        seeds = [self.search_seeds, self.block, self.worlds, self.arguments]
        ranges = {name: vars(spread) for name, spread in sorted(self.parameters.items())}
        text = json.dumps([objective, seeds, ranges, self.sampler, self.program.digest])
        return hashlib.sha256(text.encode()).hexdigest()[:16]


def _clamped(value: Any, spread: Range) -> Any:
    if spread.variants or isinstance(value, bool):
        return value
    return min(max(value, spread.minimum), spread.maximum)


def read_study(path: Path, program: str | None = None) -> Study:
    """Read a study file; raises StudyError, naming the entry that is wrong."""
    try:
        table = _Table(tomllib.loads(path.read_text()), "")
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise StudyError(f"cannot read `{path}`: {error}") from None
    try:
        study = _study(table, path, program)
        table.finish()
    except (StudyError, ExpressionError) as error:
        raise StudyError(f"{path}: {error}") from None
    return study


def _study(table: _Table, path: Path, program: str | None) -> Study:
    own = table.take("program", str, "")
    named = program or (str(path.parent / own) if own and "/" in own else own or None)
    robot = Program.find(named)
    described = robot.params(kind=table.take("kind", str, "") or None)
    seeds, objective = table.table("seeds"), table.table("objective")
    sampler, pruning = table.table("sampler"), table.table("pruning")
    search, final = seeds.seeds("search"), seeds.seeds("final")
    if shared := sorted(set(search) & set(final)):
        raise StudyError(f"seeds.search and seeds.final share seed {shared[0]}: final seeds have to be held out")
    minimize = objective.texts("minimize")
    study = Study(
        name=table.take("name", str, path.stem),
        program=robot,
        parameters=_ranges(table.table("parameters"), described),
        worlds=tuple(table.texts("worlds", ())) or (None,),
        search_seeds=search,
        final_seeds=final,
        block=seeds.take("block", int, 5),
        objectives=tuple(Expression(text) for text in minimize),
        constraints=tuple(Constraint(text) for text in objective.texts("constraints", ())),
        reported=tuple(Expression(text) for text in objective.texts("report", ())),
        sampler=sampler.take("kind", str, "tpe"),
        sampler_seed=sampler.take("seed", int, 0),
        candidates=sampler.take("candidates", int, 50),
        prune_after=pruning.take("after_blocks", int, 1) if pruning.take("enabled", bool, len(minimize) == 1) else None,
        arguments=tuple(table.texts("arguments", ())),
        timeout=table.take("timeout_s", float, 600.0),
        described=described,
    )
    for part in (seeds, objective, sampler, pruning):
        part.finish()
    _check(study)
    return study


def _check(study: Study) -> None:
    if not study.objectives or not study.parameters:
        raise StudyError("objective.minimize and parameters need at least one entry")
    if study.sampler not in SAMPLERS:
        raise StudyError(f"sampler.kind is `{study.sampler}`\n  help: samplers are {', '.join(SAMPLERS)}")
    if study.block < 1 or study.candidates < 1 or (study.prune_after is not None and study.prune_after < 1):
        raise StudyError("seeds.block, sampler.candidates and pruning.after_blocks are at least 1")
    if len(study.objectives) > 1 and (study.sampler == "cma-es" or study.prune_after is not None):
        raise StudyError("several objectives exclude cma-es and pruning\n  help: use nsga-ii")
    choices = [name for name, spread in study.parameters.items() if spread.kind in ("bool", "choice")]
    if study.sampler == "cma-es" and choices:
        raise StudyError(f"cma-es needs numbers, and `{choices[0]}` is none\n  help: use tpe")


def _ranges(table: _Table, described: Mapping[str, Parameter]) -> dict[str, Range]:
    ranges = {}
    for name in table.names():
        own, parameter = table.table(name), described.get(name)
        if parameter is None:
            near = [other for other in described if other.split(".")[0] == name.split(".")[0]] or list(described)[:10]
            raise StudyError(f"the program has no parameter `{name}`\n  help: it has {', '.join(near)}")
        if parameter.kind in ("bool", "choice"):
            ranges[name] = Range(parameter.kind, variants=parameter.variants or ("false", "true"))
        else:
            ranges[name] = _number_range(own, parameter)
        own.finish()
    return ranges


def _number_range(own: _Table, parameter: Parameter) -> Range:
    low, high = parameter.minimum or 0.0, parameter.maximum or 0.0
    spread = Range(parameter.kind, own.take("min", float, low), own.take("max", float, high), own.take("log", bool, False))
    if not low <= spread.minimum < spread.maximum <= high:
        raise StudyError(f"the range of `{parameter.name}` has to be within {low:g} to {high:g}")
    if spread.log and spread.minimum <= 0:
        raise StudyError(f"a logarithmic range of `{parameter.name}` has to begin above 0")
    return spread


class _Table:
    """A table of a TOML file that knows which of its entries were read."""

    def __init__(self, entries: dict[str, Any], path: str) -> None:
        self._entries, self._path, self._known = entries, path, set[str]()

    def names(self) -> list[str]:
        return list(self._entries)

    def take(self, name: str, kind: type[T], default: T) -> T:
        self._known.add(name)
        value = self._entries.get(name, default)
        if kind is float and isinstance(value, int) and not isinstance(value, bool):
            value = float(value)
        if not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
            raise StudyError(f"`{self._path}{name}` has to be of type {kind.__name__}")
        return value

    def texts(self, name: str, default: tuple[str, ...] | None = None) -> list[str]:
        self._known.add(name)
        value = self._entries.get(name, default)
        if value is None:
            raise StudyError(f"`{self._path}{name}` is missing")
        texts = [value] if isinstance(value, str) else list(value)
        if not all(isinstance(text, str) for text in texts):
            raise StudyError(f"`{self._path}{name}` has to be a text or a list of texts")
        return texts

    def table(self, name: str) -> _Table:
        return _Table(self.take(name, dict, {}), f"{self._path}{name}.")

    def seeds(self, name: str) -> tuple[int, ...]:
        table = self.table(name)
        first, count = table.take("first", int, -1), table.take("count", int, 0)
        table.finish()
        if first < 0 or count < 1:
            raise StudyError(f"`{self._path}{name}` needs `first`, at least 0, and `count`, at least 1")
        return tuple(range(first, first + count))

    def finish(self) -> None:
        for name in self._entries:
            if name not in self._known:
                raise StudyError(f"`{self._path}{name}` is unknown\n  help: known are {', '.join(sorted(self._known))}")
