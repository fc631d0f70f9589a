"""The states of a flow under execution, as one table (§5.9.2).

A flow is ready, its tasks are being spawned, an action of it runs, it waits at a synchronisation tag or for the flows
of a nested parallel application, it is paused, it has stopped at an error, the error is being cleared, all its actions
are done, its tasks are being killed, it has ended. Whatever changes the state of a flow stands in `TABLE`, and an event
that a state does not list is refused and changes nothing.
"""

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType


class FlowState(Enum):
    """Where a flow is."""

    READY = "ready"
    SPAWNING = "spawning"
    RUNNING = "running"
    WAITING = "waiting"
    JOINING = "joining"
    PAUSED = "paused"
    STOPPED = "stopped"
    CLEARING = "clearing"
    DONE = "done"
    KILLING = "killing"
    ENDED = "ended"


class FlowEvent(Enum):
    """What happens to a flow."""

    SPAWN = "spawn"
    """The application is run."""
    BEGIN = "begin"
    """The next action begins."""
    HOLD = "hold"
    """The next action has a synchronisation tag."""
    JOIN = "join"
    """What comes next waits for the flows of a nested parallel application."""
    REST = "rest"
    """The user has asked for a pause, or there is a breakpoint."""
    FAIL = "fail"
    """A task that is not passive has failed."""
    RECOVER = "recover"
    """The user wants the error cleared."""
    COMPLETE = "complete"
    """There is no next action."""
    KILL = "kill"
    """The application has come to its end, or is aborted."""
    GONE = "gone"
    """The last task is killed."""


_GOES_ON: Mapping[FlowEvent, FlowState] = {
    FlowEvent.BEGIN: FlowState.RUNNING,
    FlowEvent.HOLD: FlowState.WAITING,
    FlowEvent.JOIN: FlowState.JOINING,
    FlowEvent.REST: FlowState.PAUSED,
    FlowEvent.COMPLETE: FlowState.DONE,
    FlowEvent.KILL: FlowState.KILLING,
}
"""Out of every state in which a flow is between two actions, or may be sent to another."""

_LIVES = {**_GOES_ON, FlowEvent.FAIL: FlowState.STOPPED}

TABLE: Mapping[FlowState, Mapping[FlowEvent, FlowState]] = MappingProxyType(
    {
        FlowState.READY: {
            FlowEvent.SPAWN: FlowState.SPAWNING,
            FlowEvent.KILL: FlowState.KILLING,
        },
        FlowState.SPAWNING: _GOES_ON,
        FlowState.RUNNING: _LIVES,
        FlowState.WAITING: _LIVES,
        FlowState.JOINING: _LIVES,
        FlowState.PAUSED: _LIVES,
        FlowState.STOPPED: {
            FlowEvent.FAIL: FlowState.STOPPED,
            FlowEvent.RECOVER: FlowState.CLEARING,
            FlowEvent.KILL: FlowState.KILLING,
        },
        FlowState.CLEARING: _LIVES,
        FlowState.DONE: _LIVES,
        FlowState.KILLING: {
            FlowEvent.GONE: FlowState.ENDED,
        },
        FlowState.ENDED: {},
    }
)


def after(state: FlowState, event: FlowEvent) -> FlowState:
    """The state that follows; raises ValueError for an event that the state does not list."""
    following = TABLE[state].get(event)
    if following is None:
        listed = ", ".join(possible.value for possible in TABLE[state]) or "nothing more"
        raise ValueError(f"a flow that is {state.value} expects {listed}, found {event.value}")
    return following


def diagram() -> str:
    """The table as a Mermaid state diagram, for the documentation."""
    arrows = [
        f"    {state.value} --> {following.value}: {event.value}"
        for state, events in TABLE.items()
        for event, following in events.items()
    ]
    first, last = FlowState.READY.value, FlowState.ENDED.value
    return "\n".join(["stateDiagram-v2", f"    [*] --> {first}", *arrows, f"    {last} --> [*]", ""])
