"""Study files: what a search varies, plays and minimises."""

from __future__ import annotations

import hashlib
import json
import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from bica.errors import BicaError
from bica.parameters import Parameter, Setting, parsed, text
from bica.program import Program, options_of
from bica.search.expression import Constraint, Expression, ExpressionError
from bica.search.game import Task, tasks_of


class StudyError(BicaError):
    """A study file is wrong."""


#: Digits of a searched number: a tune file stays readable.
DIGITS = 4
Count = Annotated[int, Field(ge=1)]
Number = Annotated[float, Field(allow_inf_nan=False)]
#: A list of texts, or one of them.
Texts = Annotated[tuple[str, ...], BeforeValidator(lambda value: tuple(value) if isinstance(value, list) else (value,))]


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)


class _Seeds(_Table):
    first: Annotated[int, Field(ge=0)]
    count: Count

    @property
    def all(self) -> tuple[int, ...]:
        return tuple(range(self.first, self.first + self.count))


class _SeedsTable(_Table):
    search: _Seeds
    final: _Seeds
    block: Count = 5


class _Objective(_Table):
    minimize: Annotated[Texts, Field(min_length=1)]
    constraints: Texts = ()
    report: Texts = ()


class _Sampler(_Table):
    kind: Literal["tpe", "cma-es", "nsga-ii", "random"] = "tpe"
    seed: int = 0
    candidates: Count = 50


class _Pruning(_Table):
    enabled: bool | None = None
    after_blocks: Count = 1


class _RangeTable(_Table):
    min: Number | None = None
    max: Number | None = None
    log: bool = False


class _File(_Table):
    name: str | None = None
    program: str | None = None
    kind: str | None = None
    worlds: Texts = ()
    options: Texts = ()
    arguments: Texts = ()
    timeout_s: Annotated[Number, Field(gt=0)] = 600.0
    seeds: _SeedsTable
    objective: _Objective
    sampler: _Sampler = _Sampler()
    pruning: _Pruning = _Pruning()
    parameters: Annotated[dict[str, _RangeTable], Field(min_length=1)]


@dataclass(frozen=True)
class Range:
    """Range of a searched parameter; a choice has `variants` instead."""

    kind: str
    minimum: float = 0.0
    maximum: float = 0.0
    log: bool = False
    variants: tuple[str, ...] = ()
    default: Any = None

    @property
    def count(self) -> float:
        """Number of different values."""
        return len(self.variants) if self.variants else math.inf if self.kind == "f32" else self.maximum - self.minimum + 1

    def setting(self, value: Any) -> Setting:
        """Return a value of Optuna as the program takes it; the default is not rounded."""
        if value == self.default:
            value = self.default
        elif self.kind == "f32":
            value = min(max(float(f"{value:.{DIGITS}g}"), self.minimum), self.maximum)
        return parsed(self.kind, value) if self.variants else value


class Study:
    """A study file, checked against the program."""

    def __init__(self, file: _File, path: Path, program: str | None) -> None:
        """Take what a file says; a program without a folder is looked for in PATH."""
        own = str(path.absolute().parent / file.program) if file.program and "/" in file.program else file.program
        self.name = file.name or path.stem
        self.program = Program.find(program or own)
        self.described = self.program.params(kind=file.kind)
        self.parameters = {name: _range(name, table, self.described) for name, table in file.parameters.items()}
        self.sampler, self.block = file.sampler, file.seeds.block
        self.search_seeds, self.final_seeds = file.seeds.search.all, file.seeds.final.all
        self.objectives = tuple(map(Expression, file.objective.minimize))
        self.constraints = tuple(map(Constraint, file.objective.constraints))
        #: Further expressions that the report gives for the best and the default.
        self.reported = tuple(map(Expression, file.objective.report))
        is_pruned = len(self.objectives) == 1 if file.pruning.enabled is None else file.pruning.enabled
        #: Number of blocks before a candidate may be pruned; None without pruning.
        self.prune_after = file.pruning.after_blocks if is_pruned else None
        self.worlds: tuple[str | None, ...] = file.worlds or (None,)
        self.arguments, self.timeout = (*options_of(file.options), *file.arguments), file.timeout_s
        self._check()

    @property
    def defaults(self) -> dict[str, Setting]:
        """Values of the searched parameters without a search, within the ranges."""
        return {name: spread.setting(spread.default) for name, spread in self.parameters.items()}

    @property
    def notes(self) -> list[str]:
        """What a person should know before the search."""
        count = math.prod(spread.count for spread in self.parameters.values())
        is_small = count < self.sampler.candidates
        return [f"the parameters have only {count:.0f} combinations, for {self.sampler.candidates} candidates"] if is_small else []

    @property
    def expressions(self) -> list[Expression]:
        """All expressions: objectives, sides of constraints, and what is only reported."""
        sides = [side for each in self.constraints for side in (each.left, each.right)]
        return [*self.objectives, *sides, *self.reported]

    @property
    def fingerprint(self) -> str:
        """Hash of what makes the values of candidates comparable; the number of candidates is not part of it."""
        objective = [[each.text for each in self.objectives], [each.text for each in self.constraints]]
        seeds = [self.search_seeds, self.block, self.worlds, self.arguments]
        ranges = {
            name: {key: value for key, value in vars(spread).items() if key != "default"}
            for name, spread in sorted(self.parameters.items())
        }
        text = json.dumps([objective, seeds, ranges, self.sampler.kind, self.program.digest])
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def tasks(self, settings: Mapping[str, Setting], seeds: tuple[int, ...]) -> list[Task]:
        """Return the games of a candidate: for each block of seeds one in each world."""
        return tasks_of(self.program, settings, seeds, self.block, self.worlds, self.arguments, self.timeout)

    def _check(self) -> None:
        if shared := sorted(set(self.search_seeds) & set(self.final_seeds)):
            raise StudyError(f"seeds.search and seeds.final share seed {shared[0]}: final seeds have to be held out")
        is_cma = self.sampler.kind == "cma-es"
        if len(self.objectives) > 1 and (is_cma or self.prune_after is not None):
            raise StudyError("several objectives exclude cma-es and pruning\n  help: use nsga-ii")
        if is_cma and (choices := [name for name, spread in self.parameters.items() if spread.variants]):
            raise StudyError(f"cma-es needs numbers, and `{choices[0]}` is none\n  help: use tpe")


def read_study(path: Path, program: str | None = None) -> Study:
    """Read a study file; raises StudyError, naming the entry that is wrong."""
    try:
        return Study(_File.model_validate(tomllib.loads(path.read_text(encoding="utf-8-sig"))), path, program)
    except OSError as error:
        raise StudyError(f"cannot read `{path}`: {error}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        remedy = "a study is TOML: save it as UTF-8, with straight quotes"
        raise StudyError(f"cannot read `{path}`: {error}\n  help: {remedy}") from None
    except ValidationError as error:
        lines = [f"`{'.'.join(map(str, each['loc']))}` is wrong: {each['msg']}" for each in error.errors()]
        raise StudyError("\n".join([f"{path}:", *lines, "  help: docs/search.md lists all entries"])) from None
    except (StudyError, ExpressionError) as error:
        raise StudyError(f"{path}: {error}") from None


def _range(name: str, table: _RangeTable, described: Mapping[str, Parameter]) -> Range:
    parameter = described.get(name)
    if parameter is None:
        near = [other for other in described if other.startswith(f"{name.partition('.')[0]}.")] or list(described)[:10]
        raise StudyError(f"the program has no parameter `{name}`\n  help: it has {', '.join(near)}")
    if parameter.kind in ("bool", "choice"):
        if table != _RangeTable():
            raise StudyError(f"`{name}` is no number and has no range\n  help: write {{}}")
        return Range(parameter.kind, variants=parameter.variants or ("false", "true"), default=text(parameter.value))
    low, high = parameter.minimum or 0.0, parameter.maximum or 0.0
    least, most = low if table.min is None else table.min, high if table.max is None else table.max
    if parameter.kind != "f32":
        least, most = math.ceil(least), math.floor(most)
    if not low <= least < most <= high:
        raise StudyError(f"the range of `{name}` has to be within {low:g} to {high:g}")
    if table.log and least <= 0:
        raise StudyError(f"a logarithmic range of `{name}` has to begin above 0")
    kind = float if parameter.kind == "f32" else int
    return Range(parameter.kind, least, most, table.log, default=kind(min(max(float(parameter.value), least), most)))
