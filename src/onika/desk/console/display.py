"""The interface of a console display: shows lines in a terminal, a pipe or a test."""

from enum import Enum
from typing import Protocol

from onika.words.reason import Reason


class Tone(Enum):
    """How a line is meant; a terminal may colour it."""

    PLAIN = "plain"
    HEAD = "head"
    GOOD = "good"
    DIM = "dim"
    NOTE = "note"
    FAULT = "fault"
    ASK = "ask"


class ConsoleDisplay(Protocol):
    """Shows lines as they come."""

    def say(self, line: Reason, tone: Tone = Tone.PLAIN) -> None:
        """Show one line."""
        ...
