"""Expressions over the results of games, evaluated without `eval`.

A name is a column with a value for each game; one that is no name of Python stands in backticks, as in
``max(`Filter<3>.gain`)``. `mean(otherwise(goal_s, 120))` is one number. `sum`, `count` and `share` pass over missing values; all
other results of a missing value are errors, so that a game without a goal is never left out by mistake.
"""

from __future__ import annotations

import ast
import operator
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from functools import partial, reduce
from typing import Any

import numpy as np

from bica.errors import BicaError

Columns = Mapping[str, np.ndarray]


class ExpressionError(BicaError):
    """An expression is wrong, or cannot be evaluated on these results."""


class MissingValueError(ExpressionError):
    """An expression has no finite value on these results; it may have one on others."""


#: Functions with the number of their arguments.
FUNCTIONS: dict[str, tuple[int, Callable[..., Any]]] = {
    **{name: (1, getattr(np, name)) for name in ("mean", "median", "std", "min", "max", "abs", "sqrt", "log")},
    "sum": (1, np.nansum),
    "count": (1, lambda values: np.float64(np.count_nonzero(np.nan_to_num(values)))),
    "share": (1, lambda values: np.mean(np.nan_to_num(values) != 0)),
    "quantile": (2, np.quantile),
    "least": (2, np.minimum),
    "most": (2, np.maximum),
    "otherwise": (2, lambda values, instead: np.where(np.isnan(values), instead, values)),
    "where": (3, np.where),
}
OPERATORS: dict[type, Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: np.power,
    ast.USub: operator.neg,
    ast.Not: np.logical_not,
    ast.And: np.logical_and,
    ast.Or: np.logical_or,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
#: Longest expression, so that its depth has a bound.
MAX_LENGTH = 1000
#: By how much a constraint is violated, from its two sides.
VIOLATIONS: dict[type, Callable[[float, float], float]] = {
    ast.LtE: lambda left, right: left - right,
    ast.GtE: lambda left, right: right - left,
    ast.Eq: lambda left, right: abs(left - right),
}


class Expression:
    """One number over the results of games."""

    def __init__(self, text: str) -> None:
        """Parse a text; raises ExpressionError if it has anything but numbers, columns, operators and functions."""
        self.text = text
        self._evaluate = _compile(_parse(text))

    def value(self, columns: Columns) -> float:
        """Return the value; raises ExpressionError without such a column, or if the result is not one finite number."""
        try:
            with np.errstate(all="ignore"):
                value = np.asarray(self._evaluate(columns), dtype=float)
        except (TypeError, ValueError, OverflowError, ZeroDivisionError) as error:
            raise ExpressionError(f"`{self.text}` cannot be evaluated: {error}") from None
        if value.size != 1:
            raise ExpressionError(f"`{self.text}` is a value for each game\n  help: aggregate them, as `mean({self.text})`")
        if not np.isfinite(value):
            raise MissingValueError(f"`{self.text}` is {value.item()}\n  help: `otherwise(column, 120)` replaces missing values")
        return float(value.item())


class Constraint:
    """A condition over the results: two expressions with `<=`, `>=` or `==` between them."""

    def __init__(self, text: str) -> None:
        """Parse a text."""
        self.text, tree = text, _parse(text)
        if not isinstance(tree, ast.Compare) or len(tree.ops) != 1 or type(tree.ops[0]) not in VIOLATIONS:
            raise ExpressionError(f"`{text}` is no constraint\n  help: write one of <=, >= and ==, as `sum(falls) == 0`")
        self.left, right = (Expression(_unparse(side)) for side in (tree.left, tree.comparators[0]))
        self.right, self._violation = right, VIOLATIONS[type(tree.ops[0])]

    def violation(self, columns: Columns) -> float:
        """Return by how much the constraint is violated; at most 0 if it holds."""
        return self._violation(self.left.value(columns), self.right.value(columns))


def columns_of(games: Sequence[Mapping[str, Any]]) -> dict[str, np.ndarray]:
    """Return the columns of games: numbers as floats, NaN without a value, and texts."""
    names = sorted({name for game in games for name in game})
    return {name: _column([game.get(name) for game in games]) for name in names}


def _column(values: list[Any]) -> np.ndarray:
    if any(isinstance(value, str) for value in values):
        return np.array(["" if value is None else str(value) for value in values])
    return np.array([np.nan if value is None else float(value) for value in values])


def _parse(text: str) -> ast.expr:
    if len(text) > MAX_LENGTH:
        raise ExpressionError(f"an expression has at most {MAX_LENGTH} characters, this one has {len(text)}")
    try:
        quoted = re.sub("`([^`]+)`", lambda name: _QUOTED + name[1].encode().hex() + "_", text.strip())
        return ast.parse(quoted, mode="eval").body
    except (SyntaxError, ValueError, RecursionError) as error:
        raise ExpressionError(f"`{text}` is no expression: {error}") from None


#: Begin of the name of a column in backticks, before its bytes as hexadecimal digits.
_QUOTED = "_column_"


def _unparse(node: ast.expr) -> str:
    return re.sub(f"{_QUOTED}([0-9a-f]+)_", lambda name: f"`{bytes.fromhex(name[1]).decode()}`", ast.unparse(node))


def _compile(node: ast.expr) -> Callable[[Columns], Any]:
    function: Callable[..., Any]
    match node:
        case ast.Constant(value=bool() | int() | float() as number):
            return lambda columns: float(number)
        case ast.Constant(value=str() as text):
            return lambda columns: text
        case ast.Name(id=name):
            return lambda columns: _column_of(columns, name)
        case ast.Call(func=ast.Name(id=name), args=parts, keywords=[]):
            if name not in FUNCTIONS:
                raise ExpressionError(f"there is no function `{name}`\n  help: functions are {', '.join(sorted(FUNCTIONS))}")
            count, function = FUNCTIONS[name]
            if len(parts) != count:
                raise ExpressionError(f"`{_unparse(node)}` needs {count} arguments, not {len(parts)}")
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            function, parts = OPERATORS[type(op)], [left, right]
        case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATORS:
            function, parts = OPERATORS[type(op)], [operand]
        case ast.BoolOp(op=op, values=parts):
            function = partial(_reduced, OPERATORS[type(op)])
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in OPERATORS:
            function, parts = OPERATORS[type(op)], [left, right]
        case _:
            raise ExpressionError(f"`{_unparse(node)}` is not allowed\n  help: use numbers, columns, + - * / **, functions")
    values = [_compile(part) for part in parts]
    return lambda columns: function(*(value(columns) for value in values))


def _reduced(function: Callable[[Any, Any], Any], *values: Any) -> Any:
    return reduce(function, values)


def _column_of(columns: Columns, name: str) -> np.ndarray:
    name = bytes.fromhex(name.removeprefix(_QUOTED)[:-1]).decode() if name.startswith(_QUOTED) else name
    # As Python writes names, which a program need not.
    name = next((known for known in columns if unicodedata.normalize("NFKC", known) == unicodedata.normalize("NFKC", name)), name)
    if name not in columns:
        raise ExpressionError(f"the results have no column `{name}`\n  help: they have {', '.join(columns)}")
    return columns[name]
