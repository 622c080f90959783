"""Searches of a function whose optimum is known."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import optuna
import pytest
from conftest import Postgres, StudyFile
from robot import loss
from test_program import is_running, wait

from bica.cli import main
from bica.program import Program
from bica.search.game import Game
from bica.search.optimizer import Optimizer
from bica.search.store import Store, StoreError, default_url, say
from bica.search.study import read_study

#: Loss of the robot of tests at the default and at the optimum, without noise.
DEFAULT_LOSS, LEAST_LOSS = 9.75, 1.0


def trials_of(path: Path) -> list[optuna.trial.FrozenTrial]:
    return optuna.load_study(study_name=path.stem, storage=default_url(path)).trials


def ended(trials: list[optuna.trial.FrozenTrial]) -> list[optuna.trial.FrozenTrial]:
    return [each for each in trials if each.state.name in ("COMPLETE", "PRUNED") or "refused" in each.user_attrs]


def losses(study_file: StudyFile, kind: str, seed: int, candidates: int) -> float:
    """Return the loss of the best of a search that evaluates the robot's function itself, without games."""
    path = study_file(('"tpe"', f'"{kind}"\nseed = {seed}'), name=f"{kind}-{seed}")
    optimizer = Optimizer(read_study(path), Store("sqlite://", path.stem, say))
    for _ in range(candidates):
        trial = optimizer.ask()
        settings = {name: float(value) for name, value in optimizer.settings(trial).items()}
        optimizer.tell(trial, [loss(settings)], {"falls": 0.1 - settings["Walk.speed"]}, pruned=False)
    best = optimizer.best()
    assert best is not None and best.params["Walk.speed"] >= 0.1
    return float(best.user_attrs["values"][0])


@pytest.mark.parametrize("kind", ["tpe", "cma-es", "nsga-ii"])
def test_each_sampler_finds_the_known_optimum(study_file: StudyFile, kind: str) -> None:
    assert losses(study_file, kind, 1, 60) < LEAST_LOSS + 0.05 * (DEFAULT_LOSS - LEAST_LOSS)


def test_samplers_beat_random_search_of_equal_budget(study_file: StudyFile) -> None:
    mean = {kind: sum(losses(study_file, kind, seed, 40) for seed in range(3)) / 3 for kind in ("tpe", "random")}
    assert mean["tpe"] - LEAST_LOSS < mean["random"] - LEAST_LOSS


def test_a_search_improves_the_default(study_file: StudyFile, capsys: pytest.CaptureFixture[str]) -> None:
    path = study_file(("candidates = 6", "candidates = 12"))
    assert main(["search", str(path)]) == 0
    out, err = capsys.readouterr()
    speed, gain = (float(value) for value in re.findall(r"=([\d.]+)", out))
    assert loss({"Walk.speed": speed, "Walk.gain": gain}) < DEFAULT_LOSS / 2
    assert re.search(r"mean\(cost\): default 9\.\d+, best \d\.\d+, change -\d\d\.\d % \(95 % interval -", err)


def test_all_candidates_play_the_same_seeds_and_no_held_out_one(study_file: StudyFile) -> None:
    path = study_file(("[sampler]", "[pruning]\nenabled = false\n[sampler]"))
    assert main(["search", str(path)]) == 0
    store = Store(default_url(path), path.stem, say)
    seeds: dict[str, list[int]] = {}
    for game in store.games():
        seeds.setdefault(game.candidate, []).append(game.seed)
    store.close()
    for played in seeds.values():
        assert played[:4] == [100, 101, 102, 103] and played[4:] in ([], list(range(900, 906)))
    assert sum(len(played) == 10 for played in seeds.values()) == 2, "the default and the best play the held-out seeds"


def test_bad_candidates_are_pruned_after_the_first_blocks(study_file: StudyFile) -> None:
    path = study_file(("candidates = 6", "candidates = 20"))
    assert main(["search", str(path), "--workers", "1"]) == 0
    pruned = [trial for trial in trials_of(path) if trial.state == optuna.trial.TrialState.PRUNED]
    assert pruned and all(len(trial.intermediate_values) == 1 for trial in pruned)


def test_a_refused_candidate_does_not_end_the_search(study_file: StudyFile) -> None:
    path = study_file(('"Walk.speed" = {}', '"Walk.speed" = { min = 0.9 }'))
    main(["search", str(path)])
    assert any("a rule is broken" in trial.user_attrs.get("refused", "") for trial in trials_of(path))


def test_a_candidate_without_a_value_fails_alone(study_file: StudyFile, capsys: pytest.CaptureFixture[str]) -> None:
    path = study_file(("arguments = []", 'arguments = ["--none", "3"]'), ("candidates = 6", "candidates = 12"))
    assert main(["search", str(path)]) == 0
    assert {trial.state.name for trial in trials_of(path) if trial.params["Walk.gain"] < 3} == {"FAIL"}
    assert "fails: `mean(cost)` is nan" in capsys.readouterr().err


@pytest.mark.parametrize(("right", "wrong"), [("mean(cost)", "mean(kost)"), ("mean(cost)", "cost"), ("sum(falls)", "sum(drops)")])
def test_a_wrong_expression_is_found_before_the_games(study_file: StudyFile, right: str, wrong: str) -> None:
    path = study_file((right, wrong))
    assert main(["search", str(path)]) == 2
    store = Store(default_url(path), path.stem, say)
    assert len(store.games()) == 1, "the default plays the first seed"
    store.close()
    assert main(["search", str(study_file())]) == 0, "the corrected study goes on in the same store"


def test_a_search_of_few_combinations_says_so(study_file: StudyFile, capsys: pytest.CaptureFixture[str]) -> None:
    path = study_file(('"Walk.speed" = {}\n"Walk.gain" = { max = 4.5 }', '"Walk.careful" = {}'))
    path.write_text(path.read_text().replace("[objective]", '[objective]\nreport = ["mean(sqrt(0 - cost))"]'))
    assert main(["search", str(path)]) == 0
    out, err = capsys.readouterr()
    assert out in ("--set Walk.careful=false\n", "--set Walk.careful=true\n")
    assert "only 2 combinations" in err and "mean(sqrt(0 - cost)): default without a value" in err
    assert "the best candidate is the default" in err and "+0.0 %" not in err


def test_games_of_other_processors_are_not_mixed(tmp_path: Path) -> None:
    def game(seed: int, kind: str) -> Game:
        return Game("candidate", "", seed, {"wall_processor": kind}, None, 1, host="here")

    for seeds in ((1, 2), (3, 4)):
        # The store of an earlier run knows the kind of its games.
        store = Store(f"sqlite:///{tmp_path}/games.db", "study", say)
        assert store.add([game(seeds[0], "with FMA")]) == 1
        with pytest.raises(StoreError, match="of the kind with FMA; here is without FMA"):
            store.add([game(seeds[1], "without FMA")])
        store.close()


def test_the_best_is_written_and_the_report_is_one_page(study_file: StudyFile, tmp_path: Path) -> None:
    path, tune = study_file(("mean(cost)", "mean(cost + effort)")), tmp_path / "tune.toml"
    assert main(["search", str(path), "--write", str(tune)]) == 0
    assert tune.read_text().startswith("[Walk]\n")
    page = path.with_suffix(".html").read_text()
    for part in (
        "seeds 100 to 103 of the search, 900 to 905 held out",
        "<h2>Candidates",
        "study ",
        "with the hash",
        "held-out seeds",
        "Importance",
        "Slices",
        "History",
        "Walk.gain",
        "was not spent in games",
    ):
        assert part in page
    assert "processor with FMA" in page and page.count("<svg") == 4 and not re.search(r"(src|href)=\"https?:", page)


def test_a_changed_study_is_not_mixed_with_the_stored_one(study_file: StudyFile, capsys: pytest.CaptureFixture[str]) -> None:
    main(["search", str(study_file())])
    assert main(["search", str(study_file(("mean(cost)", "max(cost)")))]) == 2
    assert "give the study another name" in capsys.readouterr().err


def start(path: Path, *words: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "bica.cli", "search", str(path), "--workers", "2", *words]
    return subprocess.Popen(command, text=True, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)


def stored_after(url: str, name: str, count: int) -> None:
    """Wait until the games of a study are that many."""
    import sqlalchemy as sa

    engine = sa.create_engine(url)
    until = time.monotonic() + 120
    while time.monotonic() < until:
        try:
            with engine.connect() as connection:
                query = sa.text("select count(*) from bica_games where study = :name")
                if (connection.scalar(query, {"name": name}) or 0) >= count:
                    break
        except sa.exc.DBAPIError:
            pass
        time.sleep(0.05)
    else:
        raise AssertionError("no games were stored")
    engine.dispose()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_an_interrupted_search_continues(study_file: StudyFile, capsys: pytest.CaptureFixture[str], number: int) -> None:
    path = study_file(("arguments = []", 'arguments = ["--slow", "0.1"]'), ("candidates = 6", "candidates = 8"))
    driver = start(path)
    stored_after(default_url(path), path.stem, 9)
    os.kill(driver.pid, number)
    driver.communicate(timeout=60)
    assert driver.returncode == (130 if number != signal.SIGKILL else -signal.SIGKILL)
    store = Store(default_url(path), path.stem, say)
    before = {(game.candidate, game.seed): game for game in store.games()}
    store.close()
    assert main(["search", str(path)]) == 0
    store = Store(default_url(path), path.stem, say)
    after = {(game.candidate, game.seed): game for game in store.games()}
    assert len(after) == len(store.games()), "no game is counted twice"
    store.close()
    assert all(after[key] == game for key, game in before.items()), "accepted games stay, and are not played again"
    new = re.search(r"(\d+) games stored, (\d+) of them played by this run", capsys.readouterr().err)
    assert new is not None and int(new[1]) == len(after) and int(new[2]) == len(after) - len(before)
    assert len(ended(trials_of(path))) == 8


def test_an_interrupt_ends_long_games_at_once(study_file: StudyFile) -> None:
    driver = start(study_file(("arguments = []", 'arguments = ["--slow", "985"]')))
    wait(lambda: is_running("985"))
    driver.send_signal(signal.SIGINT)
    driver.communicate(timeout=60)
    assert driver.returncode == 130 and not is_running("985")


def test_one_process_drives_a_study(study_file: StudyFile, capsys: pytest.CaptureFixture[str]) -> None:
    path = study_file()
    store = Store(default_url(path), path.stem, say)
    assert main(["search", str(path)]) == 2
    store.close()
    assert "another process drives the study" in capsys.readouterr().err


def test_a_program_that_crashes_on_a_seed_is_counted_once(study_file: StudyFile, capsys: pytest.CaptureFixture[str]) -> None:
    path = study_file(("arguments = []", 'arguments = ["--crash", "102"]'), ("mean(cost)", "mean(otherwise(cost, 20))"))
    assert main(["search", str(path)]) == 0
    store = Store(default_url(path), path.stem, say)
    failed = [game for game in store.games() if game.error]
    store.close()
    assert {game.seed for game in failed} == {102} and all(game.tries == 3 for game in failed)
    assert f"{2 * len(failed)} tries of programs repeated, {len(failed)} games failed" in capsys.readouterr().err


def test_a_restarted_database_is_waited_for(study_file: StudyFile, postgres: Postgres, capsys: pytest.CaptureFixture[str]) -> None:
    path = study_file(("arguments = []", 'arguments = ["--slow", "0.1"]'), ("candidates = 6", "candidates = 10"), name="restart")
    driver = start(path, "--store", postgres.url)
    stored_after(postgres.url, "restart", 5)
    second = start(path, "--store", postgres.url)
    assert "another process drives" in second.communicate(timeout=60)[1]
    postgres.stop()
    time.sleep(1)
    postgres.start()
    err = driver.communicate(timeout=120)[1]
    assert driver.returncode == 0, err
    assert "the store is away, trying again" in err
    trials = optuna.load_study(study_name="restart", storage=postgres.url).trials
    assert len(ended(trials)) == 10
    stored = re.search(r"(\d+) games stored, (\d+) of them played", err)
    assert stored is not None and stored[1] == stored[2]


def test_the_objective_sees_each_world(study_file: StudyFile, robot: Program) -> None:
    path = study_file(("arguments = []", 'worlds = ["flat", "hill"]'), ("mean(cost)", "mean(where(world == 'hill', cost, 0))"))
    assert read_study(path).worlds == ("flat", "hill")
    assert main(["search", str(path)]) == 0
