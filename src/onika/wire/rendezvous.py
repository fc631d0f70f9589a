"""What the runtimes of one application say to each other so that their flows meet at synchronisation tags (§5.5.4).

One datagram holds everything that a runtime has to say: for each tag that it shares with others where its flows are,
and the times from which both ends learn how their clocks stand to each other. Who hears the newest one needs no other.
"""

import struct
from dataclasses import dataclass
from enum import IntEnum

MOST_TAGS = 56
"""More tags than these do not fit into one datagram."""

_HEAD = struct.Struct(">16sQBBqqq")
_STATE = struct.Struct(">BBIIBq")
_BEGUN, _PASSED = 1, 2
_STOP = 1


class Phase(IntEnum):
    """How the flows of one runtime stand to a tag."""

    AWAY = 0
    """They are elsewhere."""
    WAIT = 1
    """All of them are at the tag; nothing moves."""
    ARMED = 2
    """They would begin at the time that is proposed."""
    COMMITTED = 3
    """All others were ready to; these begin unless one of them is not committed too."""
    GO = 4
    """They have begun; whether all others have is not clear yet."""
    MET = 5
    """All have begun: they may go on."""
    STOPPED = 6
    """They were held: somebody did not begin, or was not heard of."""


@dataclass(frozen=True, slots=True)
class TagState:
    """What one runtime says of one tag; `at_ns` is the time of the proposal by the clock of the runtime `convenor`."""

    phase: Phase = Phase.AWAY
    visit: int = 0
    attempt: int = 0
    convenor: int = 0
    at_ns: int = 0
    has_begun: bool = False
    was_passed: bool = False


@dataclass(frozen=True, slots=True)
class RendezvousReport:
    """All that one runtime says to another; times in ns, by the clock of who took them.

    run           the number of the run, 16 bytes
    epoch         that of the life of the runtime in which the run was begun
    site          the number of the runtime in the run
    sent_ns       when this was sent
    echo_sent_ns  `sent_ns` of what was heard last from the other end; 0: nothing yet
    echo_ns       when that was heard
    """

    run: bytes
    epoch: int
    site: int
    sent_ns: int
    echo_sent_ns: int
    echo_ns: int
    tags: tuple[TagState, ...]
    is_stopped: bool = False


def encode(report: RendezvousReport) -> bytes:
    """The report as it is sealed and sent."""
    flags = _STOP if report.is_stopped else 0
    times = (report.sent_ns, report.echo_sent_ns, report.echo_ns)
    head = _HEAD.pack(report.run, report.epoch, report.site, flags, *times)
    return head + b"".join(_encode_state(state) for state in report.tags)


def decode(body: bytes) -> RendezvousReport | None:
    """The report in such bytes; None: they are none."""
    states, rest = divmod(len(body) - _HEAD.size, _STATE.size)
    if rest or not 0 <= states <= MOST_TAGS:
        return None
    run, epoch, site, flags, sent_ns, echo_sent_ns, echo_ns = _HEAD.unpack_from(body)
    try:
        tags = tuple(_decode_state(*words) for words in _STATE.iter_unpack(body[_HEAD.size :]))
    except ValueError:
        return None
    return RendezvousReport(run, epoch, site, sent_ns, echo_sent_ns, echo_ns, tags, bool(flags & _STOP))


def _encode_state(state: TagState) -> bytes:
    flags = (_BEGUN if state.has_begun else 0) | (_PASSED if state.was_passed else 0)
    return _STATE.pack(state.phase, flags, state.visit, state.attempt, state.convenor, state.at_ns)


def _decode_state(phase: int, flags: int, visit: int, attempt: int, convenor: int, at_ns: int) -> TagState:
    return TagState(Phase(phase), visit, attempt, convenor, at_ns, bool(flags & _BEGUN), bool(flags & _PASSED))
