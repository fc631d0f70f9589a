"""The states of a flow under execution, as one table (§5.9.2).

A flow is ready, its tasks are being spawned, an action of it runs, it waits at a synchronisation tag, all its
actions are done, its tasks are being killed, it has ended. Whatever changes the state of a flow stands in
`TABLE`, and an event that a state does not list is refused and changes nothing.
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
    COMPLETE = "complete"
    """There is no next action."""
    KILL = "kill"
    """The application has come to its end, or is aborted."""
    GONE = "gone"
    """The last task is killed."""


TABLE: Mapping[FlowState, Mapping[FlowEvent, FlowState]] = MappingProxyType(
    {
        FlowState.READY: {
            FlowEvent.SPAWN: FlowState.SPAWNING,
            FlowEvent.KILL: FlowState.KILLING,
        },
        FlowState.SPAWNING: {
            FlowEvent.BEGIN: FlowState.RUNNING,
            FlowEvent.HOLD: FlowState.WAITING,
            FlowEvent.COMPLETE: FlowState.DONE,
            FlowEvent.KILL: FlowState.KILLING,
        },
        FlowState.RUNNING: {
            FlowEvent.BEGIN: FlowState.RUNNING,
            FlowEvent.HOLD: FlowState.WAITING,
            FlowEvent.COMPLETE: FlowState.DONE,
            FlowEvent.KILL: FlowState.KILLING,
        },
        FlowState.WAITING: {
            FlowEvent.BEGIN: FlowState.RUNNING,
            FlowEvent.KILL: FlowState.KILLING,
        },
        FlowState.DONE: {
            FlowEvent.KILL: FlowState.KILLING,
        },
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
        listed = ", ".join(known.value for known in TABLE[state]) or "nothing more"
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
