"""The news fed to the engine: each names the flow (by number) and, where it has one, the task (law 28).

What users want of a flow comes as they sent it (`wire.steer`); it names the flow by its subsystem.
"""

from msgspec import Struct

from onika.wire.steer import Steering
from onika.words.reason import Reason


class Run(Struct, frozen=True):
    """Begin: every flow at its first action."""


class Spawned(Struct, frozen=True):
    """A task is initialised and OFF."""

    flow: int
    task: str


class Refused(Struct, frozen=True):
    """A spawn or an `on` did not happen, for this reason."""

    flow: int
    task: str
    reason: Reason


class TurnedOn(Struct, frozen=True):
    """A task is ON; said for every activation, before the task says anything else in it but that it asks or fails."""

    flow: int
    task: str


class Finished(Struct, frozen=True):
    """A trigger has ended its job: GO_TO_FLOW(choice), WHILECONTINUE if `loop`.

    `switched` is the number of the prepared case that was carried out with it; 0: none, the next switch is awaited.
    """

    flow: int
    task: str
    choice: int = 0
    loop: bool = False
    switched: int = 0


class SwitchedOff(Struct, frozen=True):
    """A task has switched itself off (signal OFF); a passive one may."""

    flow: int
    task: str


class Failed(Struct, frozen=True):
    """A task is in ERROR."""

    flow: int
    task: str
    text: Reason


class Asked(Struct, frozen=True):
    """A task needs input and waits for an answer; it is ASKING."""

    flow: int
    task: str
    reason: Reason


class Illegal(Struct, frozen=True):
    """A task says that the robot is in a state in which it may not go on (signals ILLEGAL and SHUTDOWN)."""

    flow: int
    task: str
    text: Reason


class Killed(Struct, frozen=True):
    """A task is gone."""

    flow: int
    task: str


class Cleared(Struct, frozen=True):
    """A task that was in ERROR is OFF."""

    flow: int
    task: str


class Settled(Struct, frozen=True):
    """What had to be read after the last finish has been read; the tasks may go."""


class Agreed(Struct, frozen=True):
    """The flows that were convened at a tag begin now, with those of other runtimes.

    `switched` is the number of the switches that were carried out with it; 0: none, they are awaited.
    """

    tag: str
    switched: int = 0


class Closed(Struct, frozen=True):
    """All flows of other runtimes that meet at the tag have begun, too."""

    tag: str


class BegunAlone(Struct, frozen=True):
    """What began at a tag is held, for the flows of other runtimes were not heard to have begun.

    `drives`: it may have moved something, so a user decides what follows; else all meet again at once.
    """

    tag: str
    cause: Reason
    drives: bool = True


class Abort(Struct, frozen=True):
    """End the application now; the cause is said to the user."""

    cause: Reason


TaskNews = Spawned | Refused | TurnedOn | Finished | SwitchedOff | Failed | Cleared | Asked | Illegal | Killed
News = Run | TaskNews | Steering | Settled | Agreed | Closed | BegunAlone | Abort
