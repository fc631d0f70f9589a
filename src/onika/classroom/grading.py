"""Grading what was handed in: its applications are run in virtual time, in a process confined to a copy (X25).

What a learner wrote is code that runs then, so the process reads that copy and what every seat reads, nothing else.
"""

import os
import shutil
import socket
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from onika.classroom.roster import Grade, GradedExpectation
from onika.classroom.seat_program import NICE, readable
from onika.desk.run.settings import RunSettings
from onika.desk.trial.account import RunAccount, give_account
from onika.desk.trial.trial import try_out
from onika.files import appl
from onika.files.state.state_directory import make_own
from onika.process import confinement
from onika.store.site import Site, open_site
from onika.words.condition import Condition
from onika.words.reason import NOTHING, Reason, reason_of

LIMIT_S = 120.0
"""So long a hand-in may take altogether, in seconds of the wall."""
_LONGEST_S = 600.0
"""So long a run may take, in its own time."""
_MOST = 5
"""Applications of a hand-in that are run."""


@dataclass(frozen=True, slots=True)
class Grading:
    """What is expected of a hand-in.

    expectations   conditions at the end of each of its applications
    tests          kept tests of the teacher, whose application it has
    program        the application that is meant; empty: each that is there
    """

    expectations: tuple[str, ...] = ()
    tests: tuple[Path, ...] = ()
    program: str = ""
    materials: tuple[Path, ...] = ()
    is_confined: bool = True

    @property
    def is_wanted(self) -> bool:
        """Whether anything is expected."""
        return bool(self.expectations or self.tests)


def grade_apart(grading: Grading, number: int, folder: Path, scratch: Path, answer: socket.socket) -> None:
    """Be the process that grades the hand-in in `folder`, and say the grade; `scratch` is its own, and made anew."""
    os.setsid()
    os.nice(NICE + 5)  # whoever is at work comes first
    shutil.rmtree(scratch, ignore_errors=True)
    make_own(scratch / "home")
    os.environ.update(
        HOME=str(scratch / "home"), TMPDIR=str(scratch), XDG_STATE_HOME=str(scratch), XDG_CACHE_HOME=str(scratch)
    )
    os.chdir(scratch)
    nowhere = os.open(scratch / "log", os.O_WRONLY | os.O_CREAT | os.O_CLOEXEC, 0o600)
    for descriptor in (1, 2):
        os.dup2(nowhere, descriptor)
    if grading.is_confined:
        readables = (*readable(grading.materials), folder, *(path.parent for path in grading.tests))
        devices = (Path("/dev/null"), Path("/dev/zero"), Path("/dev/shm"))  # noqa: S108 - shared memory, no file
        confinement.confine(readables, (scratch, *devices))
    try:
        made = graded(grading, number, folder)
    except (OSError, ValueError) as wrong:
        made = Grade(number, why=reason_of(wrong))
    answer.sendall(msgspec.json.encode(made))
    answer.close()


def graded(grading: Grading, number: int, folder: Path) -> Grade:
    """Run what was handed in, and say what holds."""
    names = _programs(grading, folder)
    if not names and grading.expectations:
        return Grade(number, _missed(grading), why=Reason.of("class.nothing_to_run"))
    site = open_site((folder, *grading.materials), os.environ, None)
    expectations: list[GradedExpectation] = []
    for name in names if grading.expectations else ():
        expectations += _run(grading, name, site, is_one=len(names) == 1)
    for path in grading.tests:
        verdict = try_out(path, site).verdict
        why = NOTHING if verdict.is_passed else verdict.failures[0]
        expectations.append(GradedExpectation(path.name, verdict.is_passed, why))
    return Grade(number, tuple(expectations))


def _programs(grading: Grading, folder: Path) -> Sequence[str]:
    """The applications that are to be run, by their names."""
    here = sorted(path.stem for path in (folder / "appl").glob(f"*{appl.ENDING}"))
    if grading.program:
        return [name for name in here if name == grading.program]
    return here[:_MOST]


def _run(grading: Grading, name: str, site: Site, *, is_one: bool) -> Iterator[GradedExpectation]:
    settings = RunSettings(
        name=name,
        is_virtual=True,
        with_fifo=False,
        has_black_box=False,
        expectations=tuple(map(Condition.parse, grading.expectations)),
    )
    account = give_account(settings, site, _LONGEST_S)
    why = _why(account)
    holds = {text: does_hold for text, _, does_hold in account.expectations}
    for text in grading.expectations:
        does_hold = holds.get(text.strip(), False) and not why
        yield GradedExpectation(text if is_one else f"{name}: {text}", does_hold, NOTHING if does_hold else why)


def _missed(grading: Grading) -> tuple[GradedExpectation, ...]:
    return tuple(GradedExpectation(text, holds=False) for text in grading.expectations)


def _why(account: RunAccount) -> Reason:
    """Why it did not come to its end; nothing where it did."""
    if account.refusals:
        return account.refusals[0].reason
    return account.cause
