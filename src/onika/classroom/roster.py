"""Who is in a class: learners by their seats, with all of them that outlasts a restart of the class (requirement X25).

Values only; a token is known here by its digest.
"""

import hmac
import secrets
import unicodedata
from pathlib import Path

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from onika.files import text, whole
from onika.files.state.state_directory import make_own
from onika.wire.view import ClassSeatView, SeatState
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason

NAME = "class.json"
LONGEST_NAME = 32
LONGEST_NOTE = 500
_LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789"
"""Those that nobody mistakes for each other."""
_CODE = 6


class GradedExpectation(Struct, frozen=True):
    """Something that is expected of what is handed in, and whether it holds; why not, if so."""

    text: str
    holds: bool
    why: Reason = NOTHING


class Grade(Struct, frozen=True):
    """What came of a hand-in: its number, and all that was expected of it; `why` where nothing could be tried."""

    number: int
    expectations: tuple[GradedExpectation, ...] = ()
    why: Reason = NOTHING

    @property
    def score(self) -> tuple[int, int]:
        """How many hold, of how many."""
        return sum(expectation.holds for expectation in self.expectations), len(self.expectations)


class Learner(Struct, frozen=True):
    """A learner; `may_return` while the teacher lets him in again without his cookie."""

    name: str
    seat: int
    token: str
    state: SeatState = "works"
    note: str = ""
    note_number: int = 0
    handed_in: int = 0
    grade: Grade | None = None
    may_return: bool = False

    @property
    def is_done(self) -> bool:
        """Whether all that is expected holds for what he has handed in last."""
        if self.grade is None or self.grade.number != self.handed_in:
            return False
        held, of = self.grade.score
        return held == of > 0

    @property
    def view(self) -> ClassSeatView:
        """As his page is shown it."""
        score = None if self.grade is None else self.grade.score
        return ClassSeatView(self.seat, self.name, self.state, self.note, self.note_number, self.handed_in, score)


class Roster(Struct, frozen=True):
    """All of them, in the order of their seats."""

    code: str
    seats: int
    learners: tuple[Learner, ...] = ()

    @classmethod
    def new(cls, seats: int) -> "Roster":
        """An empty one, with a code of its own."""
        return cls("".join(secrets.choice(_LETTERS) for _ in range(_CODE)), seats)

    def is_code(self, code: str) -> bool:
        """Whether somebody has said the code of the class; small letters are as good."""
        return hmac.compare_digest(code.strip().upper().encode(), self.code.encode())

    def at(self, seat: int) -> Learner | None:
        """Whose seat it is."""
        return next((learner for learner in self.learners if learner.seat == seat), None)

    def of_token(self, token: str) -> Learner | None:
        """Whose token has this digest."""
        return next((learner for learner in self.learners if hmac.compare_digest(learner.token, token)), None)

    def joined(self, name: str, token: str) -> "Roster | Reason":
        """With a learner who takes the next seat, or his own again where he may; else why not."""
        name = tidied(name)
        if not name:
            return Reason.of("class.name_wanted", most=LONGEST_NAME)
        former = next((learner for learner in self.learners if learner.name.casefold() == name.casefold()), None)
        if former is not None:
            if not former.may_return:
                return Reason.of("class.name_taken", name=former.name)
            return self.with_learner(replace(former, token=token, may_return=False))
        seat = next((seat for seat in range(1, self.seats + 1) if self.at(seat) is None), None)
        if seat is None:
            return Reason.of("class.full", seats=self.seats)
        return self.with_learner(Learner(name, seat, token))

    def with_learner(self, learner: Learner) -> "Roster":
        """With a learner in his newest form."""
        others = (other for other in self.learners if other.seat != learner.seat)
        return replace(self, learners=tuple(sorted((*others, learner), key=lambda one: one.seat)))


def tidied(name: str) -> str:
    """A name as it is shown: letters, digits and a few marks, one space between words; empty: it is none."""
    kept = "".join(letter for letter in unicodedata.normalize("NFC", name) if letter.isalnum() or letter in " .-'_")
    words = " ".join(kept.split())
    return words if 0 < len(words) <= LONGEST_NAME and words[0].isalnum() else ""


class RosterFile:
    """The file of a class, below its folder, for its owner only."""

    def __init__(self, folder: Path) -> None:
        make_own(folder)
        self._path = folder / NAME

    def read(self, seats: int) -> Roster:
        """What it holds, with so many seats at least; a new one where there is none. Raises ValueError."""
        if not self._path.exists():
            return Roster.new(seats)
        content, faults = text.load(self._path, str(self._path))
        if content is None:
            raise ValueError(faults[0].sentence)
        roster = msgspec.json.decode(content, type=Roster)
        last = max((learner.seat for learner in roster.learners), default=0)
        return replace(roster, seats=max(seats, last))

    def write(self, roster: Roster) -> Reason:
        """Keep it; why not, if so."""
        if not self._path.exists():
            self._path.touch(0o600)
        done = whole.write(self._path, msgspec.json.encode(roster).decode() + "\n", whole.ANYTHING)
        return done.reason if isinstance(done, Refusal) else NOTHING
