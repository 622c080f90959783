"""Calls of a robot's program: where it is, how it is run, and what it prints."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import signal
import subprocess
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any

from bica.errors import BicaError
from bica.parameters import Parameter, Setting, assignments, parameters_of

#: Exit codes with which a program has printed its result: the aim was reached, or not.
RESULT_CODES = (0, 1)
#: Exit code for wrong arguments, files or parameters.
REFUSED = 2


class ProgramError(BicaError):
    """A program could not be run, refused its arguments, crashed or took too long."""

    def __init__(self, message: str, *, code: int | None = None) -> None:
        super().__init__(message)
        #: Exit code, negative for a signal; None if the program did not start or was stopped.
        self.code = code

    @property
    def is_refusal(self) -> bool:
        """Whether the arguments were wrong, so that another try is useless."""
        return self.code == REFUSED


class StoppedError(ProgramError):
    """A program was killed, or not started, because this process ends."""


class Program:
    """A robot's program: the forward's `player`, or any program made with `bica-app`."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Take the program at `path`; a name without a folder is looked for in PATH."""
        found = shutil.which(os.fspath(path))
        if found is None:
            raise ProgramError(f"there is no program `{os.fspath(path)}`\n  help: give the path of a robot's program")
        self.path = Path(found).resolve()

    @classmethod
    def find(cls, path: Program | str | os.PathLike[str] | None = None) -> Program:
        """Return the program at `path`, else of the variable BICA_PROGRAM, in PATH, or in a checkout's target/release."""
        if isinstance(path, Program):
            return path
        if named := path or os.environ.get("BICA_PROGRAM") or shutil.which("player"):
            return cls(named)
        for folder in (Path.cwd(), *Path.cwd().parents):
            built = folder / "target/release/player"
            if built.is_file() and (folder / "Cargo.toml").is_file():
                return cls(built)
        raise ProgramError(
            "no program was found\n  help: give its path, set BICA_PROGRAM, or run `cargo build --release` in a checkout"
        )

    def __repr__(self) -> str:
        return f"Program({str(self.path)!r})"

    @cached_property
    def digest(self) -> str:
        """Hash of the program's file, so that all computers of a series play the same program."""
        return hashlib.sha256(self.path.read_bytes()).hexdigest()[:16]

    def call(self, arguments: Sequence[str], timeout: float | None = None) -> Any:
        """Run a command with `--json` and return what it prints; `timeout` is in seconds.

        Raises ProgramError with the program's message.
        """
        code, out, err = _run([str(self.path), *arguments, "--json"], timeout)
        if code in RESULT_CODES and (out or not err):
            try:
                return json.loads(out)
            except ValueError as error:
                raise ProgramError(f"{self.path.name} printed no JSON: {error}", code=code) from error
        what = f"was ended by {_signal(-code)}" if code < 0 else f"failed with exit code {code}"
        message = err.strip().removeprefix("error: ")
        raise ProgramError(f"{self.path.name} {what}" + (f": {message}" if message else ""), code=code)

    def play(
        self,
        seed: int = 0,
        world: str | None = None,
        set: Mapping[str, Setting] | None = None,  # noqa: A002 - the name of the option
        arguments: Sequence[str] = (),
        timeout: float | None = None,
    ) -> dict[str, Any]:
        """Play one game or run and return its result, as docs/json.md describes it."""
        words = ["--seed", str(seed), *(["--world", world] if world else []), *arguments, *assignments(set or {})]
        result: dict[str, Any] = self.call(words, timeout)
        if result.get("result") == "interrupted":
            raise ProgramError(f"{self.path.name} was interrupted")
        return result

    def params(
        self,
        set: Mapping[str, Setting] | None = None,
        kind: str | None = None,  # noqa: A002
    ) -> dict[str, Parameter]:
        """Return the parameters by their names `Component.name`; those in `set` have that value.

        `kind` is the kind of robot whose tune file counts, as the program's option `--kind`.
        """
        words = ["params", *(["--kind", kind] if kind else []), *assignments(set or {})]
        return parameters_of(self.call(["graph"]), self.call(words))

    def write(self, path: str | os.PathLike[str], set: Mapping[str, Setting], force: bool = False) -> str:  # noqa: A002
        """Write a tune file with the values in `set`; returns what the program says about it."""
        command = [str(self.path), "params", *assignments(set), "--write", os.fspath(path)]
        code, out, err = _run(command + ["--force"] * force, None)
        if code != 0:
            raise ProgramError(err.strip().removeprefix("error: "), code=code)
        return out.strip()


def options_of(options: Sequence[str]) -> tuple[str, ...]:
    """Return the words that give these options of the world, as `image=freeze`, to a program."""
    return tuple(word for option in options for word in ("--option", option))


def _signal(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


_running: set[subprocess.Popen[str]] = set()
_stopping = threading.Event()


#: A program ends with the thread that started it, even if that is killed; only Linux has this.
_PREFIX = ("setpriv", "--pdeathsig", "KILL") if shutil.which("setpriv") else ()


def _run(command: Sequence[str], timeout: float | None) -> tuple[int, str, str]:
    """Run a command in a session of its own and return exit code and outputs; it never outlives this call."""
    pipe = subprocess.PIPE
    words = [*_PREFIX, *command]
    try:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe, text=True, start_new_session=True)
    except OSError as error:
        raise ProgramError(f"cannot start `{command[0]}`: {error.strerror}") from error
    _running.add(process)
    try:
        # Only now: `stopping` kills those that were registered before.
        out, err = ("", "") if _stopping.is_set() else process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        raise ProgramError(f"{Path(command[0]).name} took more than {timeout:g} s and was stopped") from None
    finally:
        _running.discard(process)
        if process.poll() is None:
            _kill(process)
            process.communicate()
    if _stopping.is_set():
        raise StoppedError("stopped")
    return process.returncode, out, err


def _kill(process: subprocess.Popen[str]) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        process.kill()


@contextmanager
def stopping() -> Iterator[None]:
    """Within it all programs that this process started are killed, and new ones are refused."""
    _stopping.set()
    for process in list(_running):
        _kill(process)
    try:
        yield
    finally:
        _stopping.clear()
