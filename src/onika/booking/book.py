"""The book of bookings of a site: an SQLite file, in which no two bookings of a robot ever overlap (F09).

More than one program may write in it at a time: each looks and writes in one transaction.
"""

import sqlite3
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from pathlib import Path

from onika.files.state.state_directory import state_directory
from onika.wire.booking import STEP_S, Booking
from onika.words.reason import NOTHING, Reason
from onika.words.utc import utc

AHEAD_S = 60 * 86_400
LONGEST_S = 24 * 3_600
MOST = 8
"""Bookings of a user that are not over yet."""
LATE = ("stop", "finish")
_PATIENCE_S = 2.0
_LONGEST_NOTE = 200

_TABLE = """
CREATE TABLE IF NOT EXISTS booking (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    robot TEXT NOT NULL, user TEXT NOT NULL, begin_s INTEGER NOT NULL, end_s INTEGER NOT NULL,
    late TEXT NOT NULL, note TEXT NOT NULL, made_s INTEGER NOT NULL,
    cancelled_s INTEGER, cancelled_by TEXT,
    CHECK (begin_s < end_s)
) STRICT
"""
_FIELDS = "number, user, begin_s, end_s, late, note"


def book_path(environment: Mapping[str, str]) -> Path:
    """Where the book of this machine lies: in the state directory."""
    return state_directory(environment) / "bookings"


class BookRefused(Exception):
    """A booking is not made, or not changed; `reason` says why."""

    def __init__(self, reason: Reason) -> None:
        self.reason = reason
        super().__init__(reason)


class BookingBook:
    """The book at a path, made there if it is not there yet. Everything raises OSError where it cannot be used."""

    def __init__(self, path: Path) -> None:
        self._path = path
        with self._transaction() as table:
            table.execute(_TABLE)
        path.chmod(0o600)

    def stamp(self) -> tuple[int, int]:
        """Another one, once somebody has written in it."""
        status = self._path.stat()
        return status.st_mtime_ns, status.st_size

    def bookings(self, robot: str, from_s: float) -> tuple[Booking, ...]:
        """Those of a robot that are not over at this time, earliest first."""
        with self._transaction() as table:
            return _from(table, robot, from_s)

    def book(self, robot: str, wanted: Booking, now_s: float) -> Booking:
        """Make a booking, whose number is its own then; raises BookRefused."""
        fault = _fault(wanted, now_s)
        if fault:
            raise BookRefused(fault)
        with self._transaction() as table:
            others = _from(table, robot, now_s)
            _judge(wanted, others)
            if sum(other.user == wanted.user for other in others) >= MOST:
                raise BookRefused(Reason.of("booking.too_many", most=MOST))
            values = (robot, wanted.user, wanted.begin_s, wanted.end_s, wanted.late, wanted.note, int(now_s))
            made = table.execute(
                "INSERT INTO booking (robot, user, begin_s, end_s, late, note, made_s) VALUES (?, ?, ?, ?, ?, ?, ?)",
                values,
            )
            number = int(made.lastrowid or 0)
        return Booking(number, wanted.user, wanted.begin_s, wanted.end_s, wanted.late, wanted.note)

    def extend(self, robot: str, number: int, end_s: int, user: str, now_s: float) -> Booking:
        """Let a booking end at another time; raises BookRefused."""
        with self._transaction() as table:
            others = _from(table, robot, now_s)
            known = _own(others, number, user)
            wanted = Booking(number, known.user, known.begin_s, end_s, known.late, known.note)
            fault = _fault(wanted, now_s, begin_s=known.begin_s)
            if fault:
                raise BookRefused(fault)
            _judge(wanted, [other for other in others if other.number != number])
            table.execute("UPDATE booking SET end_s = ? WHERE number = ?", (end_s, number))
        return wanted

    def cancel(self, robot: str, number: int, user: str, now_s: float, *, is_owner: bool) -> Booking:
        """Take a booking back; raises BookRefused. The owner may take back everybody's."""
        with self._transaction() as table:
            others = _from(table, robot, now_s)
            known = _known(others, number) if is_owner else _own(others, number, user)
            table.execute(
                "UPDATE booking SET cancelled_s = ?, cancelled_by = ? WHERE number = ?", (int(now_s), user, number)
            )
        return known

    @contextmanager
    def _transaction(self) -> Iterator[sqlite3.Connection]:
        """All or nothing, and nobody else meanwhile."""
        try:
            with closing(sqlite3.connect(self._path, timeout=_PATIENCE_S, isolation_level=None)) as table:
                table.execute("BEGIN IMMEDIATE")
                try:
                    yield table
                except BaseException:
                    table.execute("ROLLBACK")
                    raise
                table.execute("COMMIT")
        except sqlite3.Error as wrong:
            raise OSError(Reason.of("booking.no_book", path=str(self._path), why=Reason.plain(str(wrong)))) from None


def _from(table: sqlite3.Connection, robot: str, from_s: float) -> tuple[Booking, ...]:
    rows = table.execute(
        f"SELECT {_FIELDS} FROM booking WHERE robot = ? AND end_s > ? AND cancelled_s IS NULL ORDER BY begin_s",  # noqa: S608
        (robot, from_s),
    )
    return tuple(Booking(*row) for row in rows)


def _own(bookings: tuple[Booking, ...], number: int, user: str) -> Booking:
    known = _known(bookings, number)
    if known.user != user:
        raise BookRefused(Reason.of("booking.of_another", number=number, user=known.user))
    return known


def _known(bookings: tuple[Booking, ...], number: int) -> Booking:
    for booking in bookings:
        if booking.number == number:
            return booking
    raise BookRefused(Reason.of("booking.none", number=number))


def _fault(wanted: Booking, now_s: float, begin_s: int | None = None) -> Reason:
    """What is wrong with it, whatever else is booked. A begin that stands already is not judged again."""
    if wanted.late not in LATE:
        return Reason.of("booking.late", late=wanted.late, known=LATE)
    if len(wanted.note) > _LONGEST_NOTE or not wanted.note.isprintable():
        return Reason.of("booking.note", most=_LONGEST_NOTE)
    begins_now = -STEP_S < wanted.begin_s - now_s <= 1
    if begin_s is None and not begins_now and (wanted.begin_s < now_s or wanted.begin_s % STEP_S):
        return Reason.of("booking.begin", minutes=STEP_S // 60)
    if wanted.end_s % STEP_S or wanted.end_s <= max(now_s, wanted.begin_s):
        return Reason.of("booking.end", minutes=STEP_S // 60)
    if wanted.end_s - wanted.begin_s > LONGEST_S:
        return Reason.of("booking.long", hours=LONGEST_S // 3600)
    if wanted.end_s > now_s + AHEAD_S:
        return Reason.of("booking.ahead", days=AHEAD_S // 86_400)
    return NOTHING


def _judge(wanted: Booking, others: tuple[Booking, ...] | list[Booking]) -> None:
    for other in others:
        if other.begin_s < wanted.end_s and wanted.begin_s < other.end_s:
            taken = Reason.of("booking.taken", user=other.user, begin=utc(other.begin_s), end=utc(other.end_s))
            raise BookRefused(taken)
