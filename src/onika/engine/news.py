"""The news fed to the engine: each names the flow (by number) and, where it has one, the task (law 28).

What users want of a flow comes as they sent it (`wire.steer`); it names the flow by its subsystem.
"""

from dataclasses import dataclass

from onika.wire.steer import Steering
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Run:
    """Begin: every flow at its first action."""


@dataclass(frozen=True, slots=True)
class Spawned:
    """A task is initialised and OFF."""

    flow: int
    task: str


@dataclass(frozen=True, slots=True)
class Refused:
    """A spawn or an `on` did not happen, for this reason."""

    flow: int
    task: str
    reason: Reason


@dataclass(frozen=True, slots=True)
class TurnedOn:
    """A task is ON; said for every activation, before the task says anything else in it but that it asks or fails."""

    flow: int
    task: str


@dataclass(frozen=True, slots=True)
class Finished:
    """A trigger has ended its job: GO_TO_FLOW(choice), WHILECONTINUE if `loop`.

    `switched` is the number of the prepared case that was carried out with it; 0: none, the next switch is awaited.
    """

    flow: int
    task: str
    choice: int = 0
    loop: bool = False
    switched: int = 0


@dataclass(frozen=True, slots=True)
class SwitchedOff:
    """A task has switched itself off (signal OFF); a passive one may."""

    flow: int
    task: str


@dataclass(frozen=True, slots=True)
class Failed:
    """A task is in ERROR."""

    flow: int
    task: str
    text: Reason


@dataclass(frozen=True, slots=True)
class Asked:
    """A task needs input and waits for an answer; it is ASKING."""

    flow: int
    task: str
    reason: Reason


@dataclass(frozen=True, slots=True)
class Illegal:
    """A task says that the robot is in a state in which it may not go on (signals ILLEGAL and SHUTDOWN)."""

    flow: int
    task: str
    text: Reason


@dataclass(frozen=True, slots=True)
class Killed:
    """A task is gone."""

    flow: int
    task: str


@dataclass(frozen=True, slots=True)
class Cleared:
    """A task that was in ERROR is OFF."""

    flow: int
    task: str


@dataclass(frozen=True, slots=True)
class Settled:
    """What had to be read after the last finish has been read; the tasks may go."""


@dataclass(frozen=True, slots=True)
class Agreed:
    """The flows that were convened at a tag begin now, with those of other runtimes.

    `switched` is the number of the switches that were carried out with it; 0: none, they are awaited.
    """

    tag: str
    switched: int = 0


@dataclass(frozen=True, slots=True)
class Closed:
    """All flows of other runtimes that meet at the tag have begun, too."""

    tag: str


@dataclass(frozen=True, slots=True)
class BegunAlone:
    """What began at a tag is held, for the flows of other runtimes were not heard to have begun.

    `drives`: it may have moved something, so a user decides what follows; else all meet again at once.
    """

    tag: str
    cause: Reason
    drives: bool = True


@dataclass(frozen=True, slots=True)
class Abort:
    """End the application now; the cause is said to the user."""

    cause: Reason


TaskNews = Spawned | Refused | TurnedOn | Finished | SwitchedOff | Failed | Cleared | Asked | Illegal | Killed
News = Run | TaskNews | Steering | Settled | Agreed | Closed | BegunAlone | Abort
