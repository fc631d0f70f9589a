"""Signals: one-way words from a running task, and how their numbers are made (dissertation §C.1, §C.3, Table 9)."""

from enum import Enum

from msgspec import Struct

from onika.words.module_sentence import Sentence, of_sentence
from onika.words.reason import NOTHING, Reason

END = 16
"""The number after the last signal that the runtime keeps for itself; user signals are counted from here."""


class SignalKind(Enum):
    """The eight kinds of Table 9."""

    OFF = "OFF"
    FINISH = "FINISH"
    ERROR = "ERROR"
    WARNING = "WARNING"
    SHUTDOWN = "SHUTDOWN"
    ILLEGAL = "ILLEGAL"
    LEGAL = "LEGAL"
    USER = "USER"


class Signal(Struct, frozen=True):
    """A signal; a FINISH carries the flow to go to and whether loops continue, a USER signal its number."""

    kind: SignalKind
    flow: int = 0
    loop: bool = False
    number: int = 0
    text: Reason = NOTHING


def finish(flow: int = 0, loop: bool = False) -> Signal:
    """End the job: only a trigger returns this from `cycle` (GO_TO_FLOW(flow), WHILECONTINUE if `loop`)."""
    if flow < 0:
        raise ValueError(f"expected a flow of 0 or above, found {flow}")
    return Signal(SignalKind.FINISH, flow=flow, loop=loop)


def off() -> Signal:
    """Switch this task off: only a passive task returns this, which harms no job (dissertation §C.2)."""
    return Signal(SignalKind.OFF)


def illegal(sentence: Sentence, /, **arguments: object) -> Signal:
    """The machine is in a state in which it may not go on; an application aborts."""
    return Signal(SignalKind.ILLEGAL, text=of_sentence(sentence, arguments))


def legal() -> Signal:
    """The machine is in a legal state again."""
    return Signal(SignalKind.LEGAL)


def shutdown(sentence: Sentence, /, **arguments: object) -> Signal:
    """The machine shuts down; an application aborts."""
    return Signal(SignalKind.SHUTDOWN, text=of_sentence(sentence, arguments))


def user_signal(number: int) -> Signal:
    """A signal of the laboratory's own: END + 1 is WHILECONTINUE, END + i + 2 is GO_TO_FLOW(i) (reading 19)."""
    if number <= END:
        raise ValueError(f"expected a number above {END}, found {number}")
    return Signal(SignalKind.USER, flow=max(0, number - END - 2), loop=number == END + 1, number=number)
