"""Faults on the terminal: each cause on a line, and behind it what follows from it, folded where that is much."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from onika.words.cause import FaultGroup, by_cause
from onika.words.fault import Fault
from onika.words.reason import Reason

_FEW = 2
"""Consequences that are said in full behind their cause."""


def fault_lines(faults: Iterable[Fault], *, is_whole: bool = False) -> Iterator[Reason]:
    """The lines; `is_whole`: every consequence has its own."""
    for cause in by_cause(faults):
        yield cause.fault.sentence
        if is_whole or len(cause.consequences) <= _FEW:
            yield from (Reason.of("cli.consequence", fault=each.sentence) for each in cause.consequences)
        else:
            yield _folded(cause)


def _folded(cause: FaultGroup) -> Reason:
    files = tuple(dict.fromkeys(Path(fault.place.file).name for fault in cause.consequences))
    return Reason.of("cli.consequences", count=len(cause.consequences), files=files)
