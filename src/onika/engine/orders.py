"""The orders that the engine gives: to the runner beside the robot, and notes for the people who watch."""

from msgspec import Struct

from onika.words.reason import NOTHING, Reason


class Spawn(Struct, frozen=True):
    """Bring a task of a flow to life, OFF. The runner spawns in the order of constants and reports each one."""

    flow: int
    task: str


class Launch(Struct, frozen=True):
    """One task to turn ON, with its argument line (empty for all but a trigger with a target) and its rate."""

    task: str
    arguments: str = ""
    frequency: float | None = None


class Switch(Struct, frozen=True):
    """One reconfiguration: `off` goes off, `on` comes on in this order, at one instant; what stays is not touched.

    `kept_rates` are tasks that stay ON and change their frequency at this switch (reading 13). `number` is that of the
    prepared case with which it was carried out already; 0: it is to be carried out.
    """

    flow: int
    off: tuple[str, ...]
    on: tuple[Launch, ...]
    kept_rates: tuple[tuple[str, float], ...] = ()
    number: int = 0


class Case(Struct, frozen=True):
    """What follows when the trigger ends the current action with this value; none: any. It may be prepared."""

    task: str
    choice: int | None
    loop: bool | None
    switch: Switch


class Off(Struct, frozen=True):
    """Turn one task off, outside a switch (a trigger that has finished is off already)."""

    flow: int
    task: str


class Kill(Struct, frozen=True):
    """End a task."""

    flow: int
    task: str


class Clear(Struct, frozen=True):
    """Bring a task out of ERROR; its news is Cleared, Failed or Refused."""

    flow: int
    task: str


class Together(Struct, frozen=True):
    """The switches that follow, one of each of these flows, are one: their first cycles begin at the same instant."""

    tag: str
    flows: tuple[int, ...]


class Convene(Struct, frozen=True):
    """All flows of this runtime that meet at a tag with those of others are there, and wait; News: Agreed.

    `switches` are those with which all of them go on, where that is clear already. `anew`: they have begun alone there,
    and were cleared.
    """

    tag: str
    flows: tuple[int, ...]
    switches: tuple[Switch, ...] = ()
    anew: bool = False


class Disperse(Struct, frozen=True):
    """They do not wait there any more. `was_there`: they count as having been there, for users let them pass."""

    tag: str
    was_there: bool = False


class Moved(Struct, frozen=True):
    """For the watcher: a flow has come into this state; where it waits, the tag and whom it waits for."""

    flow: int
    state: str
    index: int
    tag: str = ""
    waits_for: tuple[int, ...] = ()
    text: Reason = NOTHING


class Began(Struct, frozen=True):
    """For the watcher: an action begins; index from 0."""

    flow: int
    index: int


class Done(Struct, frozen=True):
    """For the watcher: an action has finished."""

    flow: int
    index: int


class RunNote(Struct, frozen=True):
    """For the watcher: something worth knowing that changes nothing."""

    flow: int
    text: Reason


class Settle(Struct, frozen=True):
    """All actions are done: let things settle, read what was asked for, then say Settled."""


class End(Struct, frozen=True):
    """The application is over and every task is gone."""

    completed: bool
    cause: Reason = NOTHING


MeetingOrder = Convene | Disperse
Order = Spawn | Switch | Off | Clear | Together | MeetingOrder | Kill | Began | Done | Moved | RunNote | Settle | End
