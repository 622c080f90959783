"""Expressions over results."""

from typing import Any

import numpy as np
import pytest

from bica.search.expression import Constraint, Expression, ExpressionError, columns_of

GAMES: list[dict[str, Any]] = [
    {"goal_s": 10.0, "falls": 0, "result": "goal"},
    {"goal_s": None, "falls": 2, "result": "no_goal"},
    {"goal_s": 30.0, "falls": 1, "result": "goal"},
]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("mean(otherwise(goal_s, 120))", 160 / 3),
        ("median(otherwise(goal_s, 120)) + 10 * sum(falls)", 60),
        ("share(result == 'goal')", 2 / 3),
        ("count(falls > 0 and result == 'goal')", 1),
        ("quantile(falls, 0.5) ** 2 - -1", 2),
        ("mean(where(result == 'goal', goal_s, 60))", 100 / 3),
        ("max(most(falls, 1.5)) / 4", 0.5),
    ],
)
def test_values(text: str, value: float) -> None:
    assert Expression(text).value(columns_of(GAMES)) == pytest.approx(value)


def test_any_name_of_a_column_can_be_written() -> None:
    columns = columns_of([{"höhe": 3.0, "Filter<3>.gain": 0.5, "ﬁt": 1.0}])
    for text, value in {"max(höhe)": 3, "max(ho\u0308he)": 3, "max(`Filter<3>.gain`) * 2": 1, "max(fit)": 1}.items():
        assert Expression(text).value(columns) == value
    assert Constraint("max(`Filter<3>.gain`) <= 1").left.text == "max(`Filter<3>.gain`)"
    with pytest.raises(ExpressionError, match="no column `Filter<5>`"):
        Expression("max(`Filter<5>`)").value(columns)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("mean(goal_s)", "otherwise"),
        ("goal_s", "aggregate"),
        ("mean(goals)", "no column `goals`"),
        ("mean(result)", "cannot be evaluated"),
    ],
)
def test_wrong_values_are_errors(text: str, message: str) -> None:
    with pytest.raises(ExpressionError, match=message):
        Expression(text).value(columns_of(GAMES))


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('true')",
        "goal_s.__class__",
        "(lambda: 1)()",
        "[1, 2]",
        "goal_s[0]",
        "exec('1')",
        "mean(falls, axis=0)",
        "mean()",
        "f'{falls}'",
        "(x := 1)",
        "1 if falls else 2",
        "-" * 2000 + "1",
        "(",
        "b'1'",
    ],
)
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(ExpressionError):
        Expression(text)


def test_constraints_say_by_how_much_they_are_violated() -> None:
    columns = columns_of(GAMES)
    assert Constraint("sum(falls) == 0").violation(columns) == 3
    assert Constraint("sum(falls) <= 4").violation(columns) == -1
    assert Constraint("share(result == 'goal') >= 1").violation(columns) == pytest.approx(1 / 3)
    with pytest.raises(ExpressionError, match="no constraint"):
        Constraint("sum(falls)")


def test_a_failed_game_has_missing_values() -> None:
    columns = columns_of([{"seed": 1, "falls": 1, "failed": False}, {"seed": 2, "failed": True}])
    assert np.isnan(columns["falls"][1])
    assert Expression("sum(falls) + sum(failed)").value(columns) == 2
