"""The states of a link, as each of its two ends sees it, and all their changes.

An end is APART while it has no connection; a new connection starts with a greeting, and only then is there a link.
Silence makes a link suspect first and ends it later; whatever else ends a connection leaves the end apart, from where
a new connection may resume. ENDED is for ever: this side closed the link, or the other speaks another version.
"""

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType


class LinkState(Enum):
    """How an end stands to the other one."""

    APART = "apart"
    GREETING = "greeting"
    LINKED = "linked"
    SUSPECT = "suspect"
    ENDED = "ended"


class LinkEvent(Enum):
    """What can happen to an end."""

    OPENED = "a connection is there"
    GREETED = "greeting complete"
    HEARD = "a packet came"
    QUIET = "silent for the first threshold"
    SILENT = "silent for the second threshold"
    CUT = "connection closed or unusable"
    REFUSED = "version refused"
    CLOSED = "closed by this side"


_S, _E = LinkState, LinkEvent

CHANGES: Mapping[LinkState, Mapping[LinkEvent, LinkState]] = MappingProxyType(
    {
        _S.APART: {_E.OPENED: _S.GREETING, _E.CLOSED: _S.ENDED},
        _S.GREETING: {
            _E.OPENED: _S.GREETING,
            _E.GREETED: _S.LINKED,
            _E.SILENT: _S.APART,
            _E.CUT: _S.APART,
            _E.REFUSED: _S.ENDED,
            _E.CLOSED: _S.ENDED,
        },
        _S.LINKED: {
            _E.OPENED: _S.GREETING,
            _E.HEARD: _S.LINKED,
            _E.QUIET: _S.SUSPECT,
            _E.SILENT: _S.APART,
            _E.CUT: _S.APART,
            _E.CLOSED: _S.ENDED,
        },
        _S.SUSPECT: {
            _E.OPENED: _S.GREETING,
            _E.HEARD: _S.LINKED,
            _E.SILENT: _S.APART,
            _E.CUT: _S.APART,
            _E.CLOSED: _S.ENDED,
        },
        _S.ENDED: {},
    }
)
"""Every legal change; what is not here cannot happen."""


def follow(state: LinkState, event: LinkEvent) -> LinkState:
    """The state after the event; raises ValueError where the table has none."""
    try:
        return CHANGES[state][event]
    except KeyError:
        legal = ", ".join(e.name for e in CHANGES[state]) or "nothing"
        raise ValueError(f"expected one of {legal} in state {state.name}, found {event.name}") from None


def diagram() -> str:
    """The table as a Mermaid state diagram."""
    lines = ["stateDiagram-v2", f"    [*] --> {LinkState.APART.value}"]
    for state, changes in CHANGES.items():
        lines += [f"    {state.value} --> {new.value}: {event.value}" for event, new in changes.items()]
    return "\n".join([*lines, f"    {LinkState.ENDED.value} --> [*]", ""])
