"""A steering script: its file is read and checked whole before anything moves (requirements E07, E13)."""

from dataclasses import dataclass
from math import ceil
from pathlib import Path

from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run import script_lines as lines_of, steering
from onika.desk.run.steering import Act
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

_PUSH_S = 0.05
"""Between two pushes of a stroke."""
_LONGEST_STROKE_S = 600.0


@dataclass(frozen=True, slots=True)
class ScriptLine:
    """One line: where it stands, what it says (nothing: more of the line before it), what it means."""

    place: Place
    text: str
    act: Act


def load(path: Path, flow_index: FlowIndex) -> tuple[tuple[ScriptLine, ...], list[Fault]]:
    """The lines of a script for these flows, and everything that is wrong with them."""
    lines, faults = lines_of.load(path)
    if lines is None:
        return ((), list(faults))
    return _judged(lines, flow_index)


def read(text: str, name: str, flow_index: FlowIndex) -> tuple[tuple[ScriptLine, ...], list[Fault]]:
    """As `load`, from a text that is called so."""
    return _judged(list(lines_of.lines(text, name)), flow_index)


def _judged(lines: list[tuple[Place, str]], flow_index: FlowIndex) -> tuple[tuple[ScriptLine, ...], list[Fault]]:
    script_lines: list[ScriptLine] = []
    faults: list[Fault] = []
    for place, line in lines:
        try:
            acts = [steering.act(step, flow_index) for step in steps(line)]
            script_lines += [ScriptLine(place, "" if step else line, act) for step, act in enumerate(acts)]
        except ValueError as wrong:
            faults.append(Fault(place, reason_of(wrong), Reason.of("words.nothing_run")))
    return tuple(script_lines), faults


def steps(line: str) -> tuple[str, ...]:
    """What a line means push by push: `pad 0 0 -1 for 2` is a stroke of two seconds, any other line itself.

    Before a stroke the pad is let go, as its dead-man wants it, and behind it, too; a press of the button may be the
    end of what listens, and lets go by itself. A time that is none is left where it stands: who reads the line says so.
    """
    words = line.split()
    if len(words) < 3 or words[0] != "pad" or words[-2] != "for":
        return (line,)
    try:
        seconds = float(words[-1])
    except ValueError:
        return (line,)
    if not 0.0 < seconds <= _LONGEST_STROKE_S:
        return (line,)
    push, pause = " ".join(words[:-2]), f"wait {_PUSH_S}"
    count = ceil(round(seconds / _PUSH_S, 6))
    if words[1] == "press":
        return (push, pause) * count
    return ("pad free", pause, *(push, pause) * count, "pad free")
