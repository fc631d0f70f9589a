"""The file of a sweep: what was asked in its first line, then a line for each run, written as it ends (X23).

A sweep that was broken off is gone on with from its file; a last line that was cut is done again.
"""

import os
from pathlib import Path

import msgspec
from msgspec import Struct

from onika.desk.sweep.case import CaseResult
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

_LONGEST = 1 << 28
_NOT_RUN = Reason.of("words.nothing_run")


class SweepHead(Struct, frozen=True):
    """What the runs of a file have in common."""

    sweep: int
    """The version of this format: 1."""
    command: tuple[str, ...]
    plan: str
    """A digest of what the application consists of."""


class ResultsFile:
    """An open file of results."""

    def __init__(self, path: Path, results: dict[int, CaseResult], descriptor: int) -> None:
        self.path = path
        self.results = results
        """What is known, by seed."""
        self._descriptor = descriptor

    def add(self, result: CaseResult) -> None:
        """Keep one more; raises OSError where it cannot be written."""
        self.results[result.case.seed] = result
        os.write(self._descriptor, msgspec.json.encode(result) + b"\n")

    def close(self) -> None:
        """Nothing more is added."""
        os.close(self._descriptor)


def open_results(path: Path, head: SweepHead) -> ResultsFile | Fault:
    """Begin a file, or go on with one of the same sweep; why that cannot be."""
    place = Place(str(path))
    try:
        content = path.read_bytes() if path.exists() and path.stat().st_size <= _LONGEST else b""
        whole = content[: content.rfind(b"\n") + 1]
        lines = whole.splitlines()
        if lines:
            there = msgspec.json.decode(lines[0], type=SweepHead)
            if there != head:
                return Fault(place, _other(there, head), _NOT_RUN)
        results = [msgspec.json.decode(line, type=CaseResult) for line in lines[1:]]
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        os.ftruncate(descriptor, len(whole))
        os.lseek(descriptor, 0, os.SEEK_END)
        if not lines:
            os.write(descriptor, msgspec.json.encode(head) + b"\n")
    except OSError as wrong:
        return Fault(place, system_reason(wrong), _NOT_RUN)
    except (msgspec.MsgspecError, UnicodeError) as wrong:
        return Fault(place, Reason.of("sweep.no_results", why=reason_of(wrong)), _NOT_RUN)
    return ResultsFile(path, {result.case.seed: result for result in results}, descriptor)


def _other(there: SweepHead, head: SweepHead) -> Reason:
    if there.command == head.command:
        return Reason.of("sweep.plan_changed")
    return Reason.of("sweep.other_sweep", there=" ".join(there.command), here=" ".join(head.command))
