"""The room of a class: all seats, who sits where, and what the teacher does with them (requirement X25)."""

import asyncio
import secrets
import shutil
from collections.abc import Callable, Coroutine, Sequence
from pathlib import Path
from typing import Protocol

from msgspec.structs import replace

from onika.classroom import hand_in, messages
from onika.classroom.attended_seat import HUNG_S, AttendedSeat, Begins, Hears
from onika.classroom.footprint import Footprint, footprints
from onika.classroom.roster import LONGEST_NOTE, Grade, Learner, Roster, RosterFile
from onika.link.token import digest, new_token
from onika.wire.view import SeatState
from onika.words.reason import NOTHING, Reason, reason_of

LOOK_S = 2.0
"""Between two looks at what the seats cost."""
IDLE_S = 20 * 60.0
"""A seat whose page nobody has open for so long ends; what was not saved is kept."""
_LEAVE_S = 30.0
_MOST_HAND_INS = 10
"""Of one learner that are kept; older ones go."""


class Grader(Protocol):
    """Whatever grades a hand-in, one after the other."""

    async def grade(self, number: int, folder: Path) -> Grade | None:
        """The grade of the hand-in in a folder; None: nothing is expected."""
        ...


class ClassRoom:
    """All seats of a class.

    folder     of the class; seats lie below `seats`, hand-ins below `handed-in`
    begins     says how the seat of a learner begins
    memory     bytes that one seat may take, with its runtime
    """

    def __init__(
        self,
        folder: Path,
        seats: int,
        begins: Callable[[Learner], Begins],
        grader: Grader,
        memory: int,
        make: Callable[[Begins, Hears], AttendedSeat] = AttendedSeat,
    ) -> None:
        self.folder = folder
        self._file = RosterFile(folder)
        self.roster = self._file.read(seats)
        self.trouble = self._file.write(self.roster)
        self._begins = begins
        self._grader = grader
        self._memory = memory
        self._make = make
        self._seats: dict[int, AttendedSeat] = {}
        self._empty_s: dict[int, float] = {}
        self._work: set[asyncio.Task[None]] = set()
        self._grading = asyncio.Lock()

    # -- learners

    def seat_of(self, learner: Learner) -> AttendedSeat:
        """The seat of a learner, whether its process is there or not."""
        number = learner.seat
        if number not in self._seats:
            begins = self._begins(learner)

            async def hears(news: messages.News) -> None:
                self._hear(number, news)

            self._seats[number] = self._make(begins, hears)
        return self._seats[number]

    def seat(self, number: int) -> AttendedSeat | None:
        """The seat of this number; None: nobody has it."""
        learner = self.roster.at(number)
        return None if learner is None else self.seat_of(learner)

    def join(self, name: str) -> tuple[str, Reason]:
        """A token for a new learner, or for one who may come back; else none, and why not."""
        token = new_token()
        joined = self.roster.joined(name, digest(token))
        if isinstance(joined, Reason):
            return "", joined
        learner = joined.of_token(digest(token))
        self._keep(joined)
        if learner is not None and learner.seat in self._seats:
            self._seats[learner.seat].send(messages.ShutOut())
        return token, NOTHING

    def learner(self, token: str) -> Learner | None:
        """Whose token that is."""
        return self.roster.of_token(digest(token)) if token else None

    async def admitted(self, number: int, *, is_teacher: bool = False) -> tuple[int, str] | None:
        """The port of a seat and a key to it, once it is there; None: it cannot be."""
        seat = self.seat(number)
        try:
            if seat is None or not await seat.ready():
                return None
        except OSError as wrong:
            self.trouble = reason_of(wrong)
            return None
        key = secrets.token_urlsafe(24)
        self._show(number)
        seat.send(messages.Admit(key, is_teacher))
        return seat.port, key

    # -- the teacher

    def set_state(self, numbers: Sequence[int], state: SeatState) -> None:
        """Freeze seats, take one, or let their learners work again."""
        self._change(numbers, lambda learner: replace(learner, state=state))

    def tell(self, numbers: Sequence[int], note: str) -> None:
        """Say something to learners; it stands on their page until they put it away."""
        short = " ".join(note.split())[:LONGEST_NOTE]
        self._change(numbers, lambda learner: replace(learner, note=short, note_number=learner.note_number + 1))

    def let_return(self, number: int) -> None:
        """Let somebody in under this name who does not have its cookie."""
        self._change((number,), lambda learner: replace(learner, may_return=True))

    def collect(self, numbers: Sequence[int]) -> None:
        """Have what there is handed in, also of seats that are not there now; nobody waits until they are."""
        for number in numbers:
            seat = self.seat(number)
            if seat is not None:
                self._aside(self._collect(seat))

    async def restart(self, number: int) -> None:
        """End a seat; whoever comes to it starts it anew."""
        seat = self.seat(number)
        if seat is not None:
            await seat.end(Reason.of("class.ended_by_teacher"))

    # -- while it is open

    async def keep(self) -> None:
        """Look after the seats, until it is cancelled."""
        while True:
            await asyncio.sleep(LOOK_S)
            roots = {number: seat.pid for number, seat in self._seats.items() if seat.pid is not None}
            costs = await asyncio.to_thread(footprints, tuple(roots.values()))
            for number, root in roots.items():
                await self._look(number, costs.get(root, Footprint()))

    async def close(self) -> None:
        """All seats end in order."""
        await asyncio.gather(*(seat.leave(_LEAVE_S) for seat in self._seats.values()))
        for task in self._work:
            task.cancel()

    # Inner

    async def _look(self, number: int, cost: Footprint) -> None:
        seat = self._seats[number]
        seat.footprint = cost
        why = NOTHING
        if cost.bytes > self._memory:
            why = Reason.of("class.seat_too_large", megabytes=cost.bytes >> 20, most=self._memory >> 20)
        elif seat.state == "silent" and seat.silent_s > HUNG_S:
            why = Reason.of("class.seat_hung", seconds=seat.silent_s)
        if why:
            await seat.end(why)
            return
        is_empty = seat.state == "there" and not seat.standing.pages and not seat.standing.teachers
        self._empty_s[number] = self._empty_s.get(number, 0.0) + LOOK_S if is_empty else 0.0
        if self._empty_s[number] > IDLE_S:
            self._empty_s[number] = 0.0
            await seat.leave(_LEAVE_S, Reason.of("class.seat_left", minutes=round(IDLE_S / 60)))

    def _change(self, numbers: Sequence[int], how: Callable[[Learner], Learner]) -> None:
        for number in numbers:
            learner = self.roster.at(number)
            if learner is not None:
                self._keep(self.roster.with_learner(how(learner)))
                self._show(number)

    def _keep(self, roster: Roster) -> None:
        self.roster = roster
        self.trouble = self._file.write(roster)

    def _show(self, number: int) -> None:
        learner, seat = self.roster.at(number), self._seats.get(number)
        if learner is not None and seat is not None:
            seat.send(messages.ShowSeat(replace(learner.view, began_anew=seat.began_anew)))

    def _hear(self, number: int, news: messages.News) -> None:
        if isinstance(news, messages.HandedIn) and news.folder:
            self._aside(self._take_over(number, news.folder))

    def _aside(self, work: Coroutine[None, None, None]) -> None:
        task = asyncio.create_task(work)
        self._work.add(task)
        task.add_done_callback(self._work.discard)

    async def _collect(self, seat: AttendedSeat) -> None:
        try:
            if await seat.ready():
                seat.send(messages.Collect())
        except OSError as wrong:
            self.trouble = reason_of(wrong)

    async def _take_over(self, number: int, folder: str) -> None:
        """Take a hand-in over, and grade it where it is still the newest when its turn comes."""
        learner = self.roster.at(number)
        seat = self.folder / "seats" / f"{number:02}"
        source = seat / folder
        if learner is None or not _is_hand_in(seat, folder):
            return
        handed_in = learner.handed_in + 1
        self._change((number,), lambda kept: replace(kept, handed_in=handed_in))
        target = self.folder / "handed-in" / f"{number:02} {learner.name}" / f"{handed_in:04}"
        try:
            await asyncio.to_thread(_renewed, source, target)
        except OSError as wrong:
            self.trouble = reason_of(wrong)
            return
        async with self._grading:
            newest = self.roster.at(number)
            if newest is None or newest.handed_in != handed_in:
                return
            grade = await self._grader.grade(handed_in, target)
        if grade is not None:
            self._change((number,), lambda kept: replace(kept, grade=grade))


def _is_hand_in(seat: Path, folder: str) -> bool:
    """Whether a seat names a folder of hand-ins, which lies where it should and is no way to elsewhere."""
    start, _, number = folder.partition("/")
    return start == "handed-in" and number.isdecimal() and (seat / folder).resolve() == seat.resolve() / start / number


def _renewed(source: Path, target: Path) -> None:
    """Take over, and forget what is older than the last few."""
    shutil.rmtree(target, ignore_errors=True)
    hand_in.taken_over(source, target)
    for old in sorted(target.parent.iterdir())[:-_MOST_HAND_INS]:
        shutil.rmtree(old, ignore_errors=True)
