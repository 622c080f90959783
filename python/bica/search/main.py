"""The command `bica search`."""

from __future__ import annotations

import argparse
from contextlib import closing

from bica.parameters import Setting, text
from bica.search.blocks import Blocks
from bica.search.comparison import Compared, compare, shown
from bica.search.optimizer import Optimizer
from bica.search.report import NOTHING, write_report
from bica.search.search import Search, check_columns
from bica.search.spread import spread_to
from bica.search.store import Store, default_url, say, url_of
from bica.search.study import read_study


def search(args: argparse.Namespace) -> int:
    """Run or continue a search, write its report and, with `--write`, a tune file."""
    study = read_study(args.study, args.program)
    url = url_of(args.store) if args.store else default_url(args.study)
    with closing(Store(url, study.name, say)) as store:
        if store.is_local:
            say(f"the store {url} is a SQLite file: for one process only; PostgreSQL is for all else")
        for note in study.notes:
            say(note)
        with closing(spread_to(args.address, args.workers)) as spread:
            blocks = Blocks(spread, store)
            check_columns(study, blocks)
            optimizer = Optimizer(study, store)
            Search(optimizer, blocks, say).run()
            best, compared = _compare(optimizer, blocks)
            facts = _facts(optimizer, blocks)
        for line in [*facts, *map(shown, compared)]:
            say(line)
        if best == study.defaults:
            say("the best candidate is the default")
        path = args.report or args.study.with_suffix(".html")
        write_report(path, optimizer, best, compared, facts)
        say(f"report: {path}")
    if not best:
        say(NOTHING)
        return 1
    print(" ".join(f"--set {name}={text(value)}" for name, value in best.items()))
    if args.write:
        say(study.program.write(args.write, best, args.force))
    return 0


def _compare(optimizer: Optimizer, blocks: Blocks) -> tuple[dict[str, Setting], list[Compared]]:
    """Play the best candidate and the default on the held-out seeds."""
    trial, study = optimizer.best(), optimizer.study
    if trial is None:
        return {}, []
    best = optimizer.settings(trial)
    both = [study.tasks(settings, study.final_seeds) for settings in (study.defaults, best)]
    tasks = list(dict.fromkeys(task for side in both for task in side))
    blocks.play_all(tasks, lambda played, wanted: say(f"held-out seeds: {played} of {wanted} games"))
    held_out = set(study.final_seeds)
    default, chosen = ([game for game in blocks.store.games(side[0].candidate) if game.seed in held_out] for side in both)
    expressions = [*study.objectives, *(each.left for each in study.constraints), *study.reported]
    return best, compare(expressions, default, chosen)


def _facts(optimizer: Optimizer, blocks: Blocks) -> list[str]:
    games, ended, study = blocks.store.games(), optimizer.ended(), optimizer.study
    pruned = sum(trial.state.name == "PRUNED" for trial in ended)
    refused = sum("refused" in trial.user_attrs for trial in optimizer.trials())
    failed = sum(game.error is not None for game in games)
    return [
        f"{study.sampler.kind}: {len(ended)} candidates, {pruned} of them pruned, {refused} failed",
        f"{len(games)} games stored, {blocks.new_games} of them played by this run in {blocks.elapsed_s:.0f} s",
        f"{sum(len(game.repeated) for game in games)} tries of programs repeated, {failed} games failed in all tries, "
        f"{len(blocks.store.lost())} blocks lost and played again",
        f"{100 * blocks.overhead:.1f} % of the time of {blocks.spread.slots} slots was not spent in games",
    ]
