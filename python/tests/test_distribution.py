"""Games on a Ray cluster of several nodes on this computer, and as jobs of submitit."""

import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pandas as pd
import pytest
from conftest import StudyFile

import bica
from bica import Program
from bica.cli import main


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """Three nodes with a core each."""
    pytest.importorskip("ray")
    from ray.cluster_utils import Cluster

    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    for _ in range(2):
        cluster.add_node(num_cpus=1)
    yield cluster
    cluster.shutdown()


def series(robot: Program, count: int, address: str, lines: list[str], *words: str) -> pd.DataFrame:
    arguments = ["--slow", "0.1", *words]
    return bica.series(range(count), program=robot, arguments=arguments, address=address, report=lines.append)


def test_every_fingerprint_is_that_of_one_computer(robot: Program, cluster: Any) -> None:
    lines: list[str] = []
    spread = series(robot, 12, cluster.address, lines)
    alone = bica.series(range(12), program=robot, arguments=["--slow", "0.1"])
    assert list(spread["fingerprint"]) == list(alone["fingerprint"]) and spread["seed"].is_unique
    assert "% of the time is not games" in lines[-1]


def test_a_search_runs_on_the_cluster(study_file: StudyFile, cluster: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["search", str(study_file()), "--address", cluster.address]) == 0
    assert "change -" in capsys.readouterr().err


def test_lost_workers_and_nodes_cost_no_game(robot: Program, cluster: Any) -> None:
    lines: list[str] = []
    node = cluster.add_node(num_cpus=1)

    def damage() -> None:
        while not any(line.startswith("4 of") or line.startswith("5 of") for line in lines):
            time.sleep(0.05)
        for worker in workers()[:1]:
            os.kill(worker, signal.SIGKILL)
        cluster.remove_node(node, allow_graceful=False)

    thread = threading.Thread(target=damage)
    thread.start()
    table = series(robot, 40, cluster.address, lines)
    thread.join()
    assert list(table["seed"]) == list(range(40)) and not table["failed"].any()
    assert any("are played again" in line for line in lines)
    assert "40 games, 40 of them new" in lines[-1] and "0 blocks lost" not in lines[-1]


def test_a_killed_driver_loses_no_accepted_game(robot: Program, cluster: Any, tmp_path: Path) -> None:
    words = ["series", "--games", "16", "--program", str(robot.path), "--address", cluster.address]
    words += ["--argument=--slow", "--argument=0.3", "--out", str(tmp_path / "games.parquet")]
    driver = subprocess.Popen([sys.executable, "-m", "bica.cli", *words], text=True, stderr=subprocess.PIPE)
    assert driver.stderr is not None
    accepted = 0
    for line in driver.stderr:
        if match := re.match(r"(\d+) of 16 games", line):
            accepted = int(match[1])
        if accepted >= 5:
            break
    driver.kill()
    driver.communicate()
    again = subprocess.run([sys.executable, "-m", "bica.cli", *words], text=True, capture_output=True, timeout=120, check=True)
    new = re.search(r"16 games, (\d+) of them new", again.stderr)
    assert new is not None and 1 <= int(new[1]) <= 16 - accepted
    table = pd.read_parquet(tmp_path / "games.parquet")
    assert list(table["seed"]) == list(range(16))


def test_jobs_of_submitit_are_played(robot: Program, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("submitit")
    monkeypatch.chdir(tmp_path)
    lines: list[str] = []
    table = series(robot, 4, "slurm:local", lines)
    alone = bica.series(range(4), program=robot, arguments=["--slow", "0.1"])
    assert list(table["fingerprint"]) == list(alone["fingerprint"])


def workers() -> list[int]:
    """Return the processes of Ray that play a block."""
    found = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if path.read_bytes().startswith(b"ray::play_block"):
                found.append(int(path.parent.name))
        except OSError:
            continue
    return found
