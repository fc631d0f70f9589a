"""Values of variables at every cycle, as a scope shows them (requirements C14, C27); what was lost is told.

Each value of a variable has a number, counted from when it was first asked for. A gap between numbers is values that
were written over before anybody looked.
"""

from msgspec import Struct

from onika.words.reason import NOTHING, Reason

MOST_VARIABLES = 16
"""So many may be asked for at once."""
KEPT_NS = 30_000_000_000
"""A value is kept for so long, and for less where there are too many."""


class Sample(Struct, frozen=True, tag=True):
    """Ask for values of variables `SUBSYSTEM/NAME`; replied by Sampled.

    Who asks has them kept from now on, as long as he goes on asking.
    """

    variables: tuple[str, ...]
    after: tuple[int, ...] = ()
    """Of each the number of the last value that he has; empty: all that are kept are wanted."""


class SampleStretch(Struct, frozen=True):
    """Values that follow each other without a gap, evenly in time."""

    first: int
    """The number of the first one."""
    begin_ns: int
    """Its time."""
    step_ns: int
    count: int


class SampleTrace(Struct, frozen=True):
    """What came of a variable after the number asked for; of very many the first ones, the others when asked again."""

    variable: str
    type: str = ""
    stretches: tuple[SampleStretch, ...] = ()
    values: bytes = b""
    """The values of all stretches, one after the other, as they lie in memory."""
    reason: Reason = NOTHING
    """Why there are no further values; else empty."""


class Sampled(Struct, frozen=True, tag=True):
    """The traces in the order in which they were asked for."""

    now_ns: int
    traces: tuple[SampleTrace, ...]
