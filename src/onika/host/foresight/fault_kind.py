"""A fault that could come: whom it could concern, what is asked, and what it does first (requirement X24)."""

from collections.abc import Callable
from dataclasses import dataclass

from onika.host.foresight.outlook import Outlook
from onika.host.foresight.situation import Situation
from onika.words.reason import Reason

EVERYBODY = ("",)
"""The one subject of a fault that concerns nobody in particular."""


@dataclass(frozen=True, slots=True)
class FaultKind:
    """What there is to know of one kind of fault."""

    name: str
    """The word by which it is asked."""
    subjects: Callable[[Situation], tuple[str, ...]]
    """Whom it could concern now; nobody: it cannot come."""
    question: Callable[[str], Reason]
    unfold: Callable[[Outlook, str], None]
    """Puts the outlook through it."""
    to_do: Callable[[Outlook, str], tuple[Reason, ...]] = lambda _outlook, _subject: ()
    """What a person has to do then."""
    notes: Callable[[Outlook, str], tuple[Reason, ...]] = lambda _outlook, _subject: ()
    """What is worth knowing besides."""
