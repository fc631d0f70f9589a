"""A script that steers a run: lines in a file, read whole before anything moves (requirements E07, E13)."""

from dataclasses import dataclass
from pathlib import Path

from onika.desk.plan.flow_index import Cast
from onika.desk.run import script_lines as lines_of, steering
from onika.desk.run.steering import Act
from onika.desk.run.steering_fault import objection
from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class Cue:
    """One line: where it stands, what it says, what it means."""

    place: Place
    text: str
    act: Act


def load(path: Path, cast: Cast) -> tuple[tuple[Cue, ...], list[Fault]]:
    """The lines of a script for these flows, and everything that is wrong with them."""
    lines, faults = lines_of.load(path)
    return ((), list(faults)) if lines is None else _judged(lines, cast)


def read(text: str, name: str, cast: Cast) -> tuple[tuple[Cue, ...], list[Fault]]:
    """As `load`, from a text that is called so."""
    return _judged(list(lines_of.lines(text, name)), cast)


def _judged(lines: list[tuple[Place, str]], cast: Cast) -> tuple[tuple[Cue, ...], list[Fault]]:
    cues: list[Cue] = []
    faults: list[Fault] = []
    for place, line in lines:
        try:
            cues.append(Cue(place, line, steering.act(line, cast)))
        except ValueError as wrong:
            faults.append(objection(place, str(wrong), "nothing is run"))
    return tuple(cues), faults
