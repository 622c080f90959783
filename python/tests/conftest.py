"""What several tests need."""

import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from bica import Program

StudyFile = Callable[..., Path]


@pytest.fixture(scope="session")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Program:
    """The program of tests, whose optimum is known."""
    path = tmp_path_factory.mktemp("robot") / "robot"
    path.write_text(f'#!/bin/sh\nexec {sys.executable} -I -S {Path(__file__).with_name("robot.py")} "$@"\n')
    path.chmod(0o755)
    return Program(path)


@pytest.fixture(scope="session")
def player() -> Program:
    """The forward's program, if it is built."""
    return Program.find(os.environ.get("BICA_PROGRAM") or Path(__file__).parents[2] / "target/release/player")


@pytest.fixture
def study_file(tmp_path: Path, robot: Program) -> StudyFile:
    """Writes a study; further texts replace entries."""

    def write(*replaced: tuple[str, str], name: str = "study", path: Path = tmp_path) -> Path:
        text = STUDY.format(program=robot.path)
        for old, new in replaced:
            assert old in text
            text = text.replace(old, new)
        file = path / f"{name}.toml"
        file.write_text(text)
        return file

    return write


STUDY = """program = "{program}"
arguments = []
[seeds]
search = {{ first = 100, count = 4 }}
final = {{ first = 900, count = 6 }}
block = 2
[objective]
minimize = "mean(cost)"
constraints = ["sum(falls) == 0"]
[sampler]
kind = "tpe"
candidates = 6
[parameters]
"Walk.speed" = {{}}
"Walk.gain" = {{ max = 4.5 }}
"""


class Postgres:
    """A database server of its own, without access from other computers."""

    def __init__(self, folder: Path) -> None:
        found = sorted(Path("/usr/lib/postgresql").glob("*/bin"))
        self._bin = found[-1] if found else None
        self._folder = folder
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.url = f"postgresql+psycopg2://postgres@127.0.0.1:{self.port}/postgres"

    @property
    def is_installed(self) -> bool:
        return self._bin is not None or shutil.which("pg_ctl") is not None

    def run(self, program: str, *words: str) -> None:
        path = self._bin / program if self._bin else Path(program)
        # The server refuses to run as root.
        user = ["setpriv", "--reuid=postgres", "--regid=postgres", "--clear-groups"] if os.geteuid() == 0 else []
        log = (self._folder / "log").open("a")
        subprocess.run([*user, path, *words], check=True, stdout=log, stderr=log, cwd=self._folder, timeout=60)

    def create(self) -> None:
        if os.geteuid() == 0:
            shutil.chown(self._folder, "postgres")
        self.run("initdb", "-D", str(self._folder / "data"), "-U", "postgres", "-A", "trust", "--no-sync")

    def start(self) -> None:
        options = f"-p {self.port} -k {self._folder} -c listen_addresses=127.0.0.1 -c fsync=off"
        self.run("pg_ctl", "-D", str(self._folder / "data"), "-w", "-o", options, "-l", str(self._folder / "server"), "start")

    def stop(self) -> None:
        self.run("pg_ctl", "-D", str(self._folder / "data"), "-w", "-m", "immediate", "stop")


@pytest.fixture(scope="session")
def postgres() -> Iterator[Postgres]:
    """A running server; the test is skipped without an installed one."""
    import tempfile

    with tempfile.TemporaryDirectory(prefix="bica-pg-", ignore_cleanup_errors=True) as folder:
        server = Postgres(Path(folder))
        if not server.is_installed:
            pytest.skip("PostgreSQL is not installed; `apt-get install postgresql` brings it")
        server.create()
        server.start()
        yield server
        server.stop()
