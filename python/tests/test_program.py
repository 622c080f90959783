"""Calls of programs."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import bica
from bica import Program, ProgramError


def test_a_game_is_played_with_its_settings(robot: Program) -> None:
    plain = bica.play(seed=3, world="hall", program=robot)
    tuned = bica.play(seed=3, set={"Walk.speed": 0.3, "Walk.gain": 1.5}, program=robot)
    assert (plain["seed"], plain["world"]) == (3, "hall")
    assert tuned["cost"] == pytest.approx(1, abs=0.05) and plain["cost"] > 8


def test_parameters_have_ranges_units_and_values(robot: Program) -> None:
    params = bica.params({"Walk.gain": 2.0}, program=robot)
    gain, careful = params["Walk.gain"], params["Walk.careful"]
    assert (gain.minimum, gain.maximum, gain.default, gain.value) == (0.1, 5.0, 4.0, 2.0)
    assert params["Walk.speed"].unit == "m/s" and careful.value is False


def test_an_error_is_the_message_of_the_program(robot: Program) -> None:
    with pytest.raises(ProgramError, match="there is no parameter `Walk.sped`") as refused:
        bica.play(set={"Walk.sped": 1.0}, program=robot)
    assert refused.value.is_refusal
    with pytest.raises(ProgramError, match="SIGABRT"):
        bica.play(seed=4, arguments=["--crash", "4"], program=robot)


def test_a_missing_program_is_named() -> None:
    with pytest.raises(ProgramError, match="no program `/nowhere/player`"):
        bica.play(program="/nowhere/player")


def test_a_program_without_json_is_named() -> None:
    with pytest.raises(ProgramError, match="true printed no JSON"):
        bica.play(program="/bin/true")


def test_a_program_that_takes_too_long_is_killed(robot: Program) -> None:
    with pytest.raises(ProgramError, match=r"more than 0\.5 s"):
        bica.play(arguments=["--slow", "987"], timeout=0.5, program=robot)
    assert not is_running("987")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_no_program_outlives_its_caller(robot: Program, number: int) -> None:
    # A shell starts what runs in its background with SIGINT ignored.
    heed = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    code = f"{heed}; import bica; bica.play(program={str(robot.path)!r}, arguments=['--slow', '986'])"
    caller = subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.DEVNULL)
    wait(lambda: is_running("986"))
    os.kill(caller.pid, number)
    caller.wait(60)
    wait(lambda: not is_running("986"))


def test_a_series_is_a_table_with_a_row_for_each_seed(robot: Program) -> None:
    table = bica.series([7, 5, 9], program=robot, arguments=["--crash", "9"])
    assert list(table["seed"]) == [5, 7, 9] and list(table["failed"]) == [False, False, True]
    assert "SIGABRT" in table["error"].iloc[2] and table["tries"].iloc[2] == 3


def is_running(word: str) -> bool:
    lines = [path.read_bytes() for path in Path("/proc").glob("[0-9]*/cmdline") if path.exists()]
    return any(b"robot.py" in line and word.encode() in line.split(b"\0") for line in lines)


def wait(condition: object, limit: float = 60) -> None:
    until = time.monotonic() + limit
    while not condition():  # type: ignore[operator]
        assert time.monotonic() < until
        time.sleep(0.05)
