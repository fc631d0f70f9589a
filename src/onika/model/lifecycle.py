"""The lifecycle of a task as one table: everything that affects its state is in this file (law 11, requirement A05).

WAITING: spawned, but a constant it needs has no supplier yet; `init` is postponed.
OFF: initialised, not cycling.                ASKING: told to go on, waits for user input.
ON: cycling, or waiting for its event.        ERROR: gave up; `clear` brings it back to OFF.
KILLED: gone.

An illegal command changes nothing and is refused with the reason.
"""

from enum import Enum

from onika.words.reason import NOTHING, Reason, reason_of


class State(Enum):
    """Where a task is in its life."""

    WAITING = "WAITING"
    OFF = "OFF"
    ASKING = "ASKING"
    ON = "ON"
    ERROR = "ERROR"
    KILLED = "KILLED"

    __hash__ = object.__hash__  # a member is one object: quicker than the hash of its name, at every step of a switch


class LifecycleInput(Enum):
    """What can happen to a task: commands from outside, and what comes out of its own code."""

    INITIALISED = "initialised"
    ON = "on"
    ASK = "ask"
    ANSWERED = "answered"
    OFF = "off"
    FINISH = "finish"
    FAIL = "fail"
    CLEAR = "clear"
    REINIT = "reinit"
    REBIND = "rebind"
    SWAP = "swap"
    KILL = "kill"

    __hash__ = object.__hash__


TABLE: dict[State, dict[LifecycleInput, State]] = {
    State.WAITING: {
        LifecycleInput.INITIALISED: State.OFF,
        LifecycleInput.REBIND: State.WAITING,
        LifecycleInput.FAIL: State.ERROR,
        LifecycleInput.KILL: State.KILLED,
    },
    State.OFF: {
        LifecycleInput.ON: State.ON,
        LifecycleInput.ASK: State.ASKING,
        LifecycleInput.OFF: State.OFF,
        LifecycleInput.REINIT: State.OFF,
        LifecycleInput.REBIND: State.OFF,
        LifecycleInput.SWAP: State.OFF,
        LifecycleInput.FAIL: State.ERROR,
        LifecycleInput.KILL: State.KILLED,
    },
    State.ASKING: {
        LifecycleInput.ANSWERED: State.ON,
        LifecycleInput.ASK: State.ASKING,
        LifecycleInput.OFF: State.OFF,
        LifecycleInput.FAIL: State.ERROR,
        LifecycleInput.KILL: State.KILLED,
    },
    State.ON: {
        LifecycleInput.OFF: State.OFF,
        LifecycleInput.FINISH: State.OFF,
        LifecycleInput.SWAP: State.ON,
        LifecycleInput.FAIL: State.ERROR,
        LifecycleInput.KILL: State.KILLED,
    },
    State.ERROR: {
        LifecycleInput.CLEAR: State.OFF,
        LifecycleInput.OFF: State.ERROR,
        LifecycleInput.REBIND: State.ERROR,
        LifecycleInput.SWAP: State.ERROR,
        LifecycleInput.FAIL: State.ERROR,
        LifecycleInput.KILL: State.KILLED,
    },
    State.KILLED: {LifecycleInput.KILL: State.KILLED, LifecycleInput.OFF: State.KILLED},
}


class IllegalTransition(Exception):
    """A step that the table does not allow in this state; nothing has changed."""


def after(state: State, step: LifecycleInput) -> State:
    """The state after a step; raises IllegalTransition and changes nothing where the table has no entry."""
    try:
        return TABLE[state][step]
    except KeyError:
        allowed = tuple(sorted(command.value for command in TABLE[state]))
        reason = Reason.of("rules.step_not_allowed", allowed=allowed, state=state.value, step=step.value)
        raise IllegalTransition(reason) from None


def refusal(state: State, step: LifecycleInput) -> Reason:
    """Why the table does not allow a step in this state; empty where it does."""
    try:
        after(state, step)
    except IllegalTransition as refused:
        return reason_of(refused)
    return NOTHING


def diagram() -> str:
    """The table as a Mermaid state diagram."""
    lines = ["stateDiagram-v2", "    [*] --> WAITING : spawn"]
    lines += [
        f"    {state.value} --> {following.value} : {step.value}"
        for state, steps in TABLE.items()
        for step, following in steps.items()
        if following is not state
    ]
    return "\n".join([*lines, "    KILLED --> [*]"]) + "\n"
