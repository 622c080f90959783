"""Command line of the package: `bica search` and `bica series`."""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from types import FrameType

from bica.errors import BicaError
from bica.parameters import Setting
from bica.program import options_of

INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns its exit code: 0 done, 1 nothing was found, 2 wrong arguments or files, 130 interrupted."""
    args = _parser().parse_args(arguments)
    # A shell starts what runs in its background with SIGINT ignored.
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGALRM):
        signal.signal(number, _interrupt)
    try:
        if args.command == "series":
            return _series(args)
        from bica.search.main import search

        return search(args)
    except KeyboardInterrupt:
        signal.setitimer(signal.ITIMER_REAL, 0)
        print("interrupted; the same command continues", file=sys.stderr)
        return INTERRUPTED
    except ImportError as error:
        print(f'error: {error}\n  help: `pip install "./python[search]"` in a checkout brings it', file=sys.stderr)
        return 2
    except (BicaError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2


def _interrupt(number: int, frame: FrameType | None) -> None:
    # Python loses an exception that is raised in a destructor or a callback: it is raised again until `main` has it.
    signal.setitimer(signal.ITIMER_REAL, 5)
    raise KeyboardInterrupt


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="bica", description="Searches and series of a robot's program.")
    commands = parser.add_subparsers(dest="command", required=True)
    search = commands.add_parser("search", help="search parameters; the same command continues an interrupted search")
    search.add_argument("study", type=Path, metavar="STUDY.toml", help="the study file: see docs/search.md")
    search.add_argument("--report", type=Path, metavar="FILE.html", help="page of the results [default: beside the study]")
    search.add_argument("--write", type=Path, metavar="FILE", help="write the best as a tune file, as tune/mujoco.toml")
    search.add_argument("--force", action="store_true", help="replace the file of --write if it exists")
    series = commands.add_parser("series", help="play games with consecutive seeds, and write them as Parquet")
    series.add_argument("--games", type=int, required=True, metavar="N", help="number of games")
    series.add_argument("--seed", type=int, default=0, metavar="N", help="first seed [default: 0]")
    series.add_argument("--world", help="world of the games")
    series.add_argument("--set", action="append", default=[], metavar="COMPONENT.NAME=VALUE", help="set a parameter")
    series.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help="option of the world, as a fault")
    series.add_argument("--argument", action="append", default=[], metavar="WORD", help="further word for the program")
    series.add_argument("--timeout", type=float, default=600.0, metavar="S", help="longest duration of a game, s")
    series.add_argument("--out", type=Path, default=Path("games.parquet"), metavar="FILE", help="[default: games.parquet]")
    for command in (search, series):
        command.add_argument("--program", metavar="PATH", help="the robot's program [default: BICA_PROGRAM, PATH, checkout]")
        command.add_argument("--store", metavar="URL", help="database, as postgresql://… [default: a SQLite file]")
        command.add_argument("--address", help="a Ray cluster, `local` for one on this computer, `slurm`, `slurm:local`")
        command.add_argument("--workers", type=int, metavar="N", help="games at once [default: one for each core]")
    return parser


def _series(args: argparse.Namespace) -> int:
    from bica.search.series import series
    from bica.search.store import default_url, say, url_of

    url = url_of(args.store) if args.store else default_url(args.out)
    options = {"address": args.address, "workers": args.workers, "store": url, "report": say}
    given = {"program": args.program, "arguments": [*options_of(args.option), *args.argument], "timeout": args.timeout}
    frame = series(range(args.seed, args.seed + args.games), args.world, _settings(args.set), **given, **options)
    frame.to_parquet(args.out)
    say(f"{len(frame)} games in {args.out}")
    return 0


def _settings(words: Sequence[str]) -> dict[str, Setting]:
    pairs = [word.partition("=") for word in words]
    if wrong := [name for name, equals, value in pairs if not equals or not value]:
        raise BicaError(f"`--set {wrong[0]}` has no value\n  help: write --set Component.name=value")
    return {name: value for name, _, value in pairs}


if __name__ == "__main__":
    sys.exit(main())
