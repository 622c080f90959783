"""Storage of accepted games in PostgreSQL, or in a SQLite file of one process."""

from __future__ import annotations

import fcntl
import json
import os
import sys
import time
import zlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import IO, TypeVar

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite

from bica.errors import BicaError
from bica.search.game import Game

T = TypeVar("T")

#: Value of a game that names the kind of its processor: programs of BICA print it.
PROCESSOR = "wall_processor"
#: Longest time for which a database may be away, s.
PATIENCE = 120.0

_metadata = sa.MetaData()
_games = sa.Table(
    "bica_games",
    _metadata,
    sa.Column("study", sa.String(200), primary_key=True),
    sa.Column("candidate", sa.String(16), primary_key=True),
    sa.Column("world", sa.String(100), primary_key=True),
    sa.Column("seed", sa.BigInteger, primary_key=True),
    sa.Column("game", sa.Text, nullable=False),
)
_lost = sa.Table(
    "bica_lost_blocks",
    _metadata,
    sa.Column("id", sa.Integer, primary_key=True),
    sa.Column("study", sa.String(200), nullable=False),
    sa.Column("what", sa.Text, nullable=False),
)


class StoreError(BicaError):
    """A store cannot be used."""


def url_of(text: str) -> str:
    """Return a database's URL; a path without a scheme is a SQLite file."""
    return text if "://" in text else f"sqlite:///{Path(text).resolve()}"


class Store:
    """Games of one study. A game is stored once, whatever is played or reported twice."""

    def __init__(self, url: str, study: str, report: Callable[[str], None]) -> None:
        """Open the store and lock the study; raises StoreError if another process drives it."""
        self.url, self.study, self._report = url, study, report
        self._file: IO[str] | None = None
        self._guard: sa.Connection | None = None
        self._processor: str | None = None
        options = {} if url.startswith("sqlite") else {"pool_pre_ping": True}
        try:
            self.engine = sa.create_engine(url, **options)
            self._lock()
            _metadata.create_all(self.engine)
        except (sa.exc.SQLAlchemyError, ImportError, OSError) as error:
            raise StoreError(f"cannot open the store `{url}`: {_first_line(error)}") from error

    @property
    def is_in_memory(self) -> bool:
        """Whether nothing is kept after the process."""
        return self.url == "sqlite://"

    @property
    def is_local(self) -> bool:
        """Whether the store is a SQLite file, which only one process may use."""
        return self.engine.dialect.name == "sqlite"

    def close(self) -> None:
        """Unlock the study."""
        if self._guard is not None:
            self._guard.close()
        if self._file is not None:
            self._file.close()
        self.engine.dispose()

    def _lock(self) -> None:
        taken = f"another process drives the study `{self.study}` in `{self.url}`\n  help: wait for its end, or stop it"
        if self.is_in_memory:
            return
        if self.is_local:
            self._file = Path(f"{self.engine.url.database}.lock").open("w")  # noqa: SIM115 - open as long as the store
            try:
                fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise StoreError(taken) from None
        else:
            key = zlib.crc32(self.study.encode())
            self._guard = self.engine.connect().execution_options(isolation_level="AUTOCOMMIT")
            if not self._guard.scalar(sa.select(sa.func.pg_try_advisory_lock(key))):
                raise StoreError(taken)

    def _relock(self) -> None:
        """Take the lock again after the database was away."""
        if self._guard is not None:
            try:
                self._guard.scalar(sa.select(1))
            except sa.exc.SQLAlchemyError:
                self._guard.close()
                self._lock()

    def patiently(self, action: Callable[[], T]) -> T:
        """Run an action that may be repeated; waits for a database that is away, at most for PATIENCE."""
        until, wait = time.monotonic() + PATIENCE, 0.2
        while True:
            try:
                self._relock()
                return action()
            except Exception as error:
                cause = error if isinstance(error, sa.exc.DBAPIError) else error.__cause__ or error.__context__
                away = sa.exc.OperationalError | sa.exc.InterfaceError | sa.exc.PendingRollbackError
                is_away = isinstance(cause, away) and not self.is_local
                if not is_away or time.monotonic() > until:
                    raise
                self._report(f"the store is away, trying again: {_first_line(error)}")
            time.sleep(wait)
            wait = min(2 * wait, 5.0)

    def _execute(self, action: Callable[[sa.Connection], T]) -> T:
        def transaction() -> T:
            with self.engine.begin() as connection:
                return action(connection)

        return self.patiently(transaction)

    def _check_processor(self, games: Iterable[Game]) -> None:
        """Refuse games of another kind of processor than that of the first game: equal seeds may be different games there."""
        for game in games:
            kind = game.values.get(PROCESSOR)
            self._processor = self._processor or kind
            if kind and kind != self._processor:
                raise StoreError(
                    f"the games of `{self.study}` in `{self.url}` are of processors of the kind {self._processor}; {game.host} is "
                    f"{kind}\n  help: use computers of one kind, or another store: on the other kind a seed may be another game"
                )

    def add(self, games: Sequence[Game]) -> int:
        """Store games; returns how many of them were new. Raises StoreError if they are of another kind of processor."""
        if self._processor is None:
            self._check_processor(self.games())
        self._check_processor(games)
        insert = (sqlite.insert(_games) if self.is_local else postgresql.insert(_games)).on_conflict_do_nothing()
        keys = ("candidate", "world", "seed")
        rows = [{"study": self.study, "game": json.dumps(row), **{key: row[key] for key in keys}} for row in map(asdict, games)]
        return self._execute(lambda connection: sum(connection.execute(insert, row).rowcount for row in rows))

    def games(self, candidate: str | None = None) -> list[Game]:
        """Return the stored games, of one candidate or of all."""
        query = sa.select(_games.c.game).where(_games.c.study == self.study).order_by(_games.c.seed)
        if candidate is not None:
            query = query.where(_games.c.candidate == candidate)
        return [Game(**json.loads(text)) for text in self._execute(lambda connection: list(connection.scalars(query)))]

    def note_lost(self, what: str) -> None:
        """Store that a block was lost and is played again."""
        self._report(what)
        self._execute(lambda connection: connection.execute(_lost.insert().values(study=self.study, what=what)))

    def lost(self) -> list[str]:
        """Return what was lost and played again, in its order."""
        query = sa.select(_lost.c.what).where(_lost.c.study == self.study).order_by(_lost.c.id)
        return self._execute(lambda connection: list(connection.scalars(query)))


def _first_line(error: BaseException) -> str:
    return str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__


def say(text: str) -> None:
    """Print a line about progress."""
    print(text, file=sys.stderr, flush=True)


def default_url(path: Path) -> str:
    """Return the URL of the SQLite file beside another file."""
    return f"sqlite:///{os.path.abspath(path)}.db"
