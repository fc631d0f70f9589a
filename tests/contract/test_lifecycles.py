"""One rule, all tables of states: complete, closed, leading to an end, and refusing with a reason what they lack."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any

import pytest

from onika.engine import flow
from onika.link import state as link
from onika.model import lifecycle as task
from onika.ring import drive


@dataclass(frozen=True)
class Machine:
    """A table, the function that reads it, where it begins, and the states that nothing leaves."""

    name: str
    table: Mapping[Any, Mapping[Any, Any]]
    states: type[Enum]
    events: type[Enum]
    after: Callable[[Any, Any], Any]
    refuses: type[Exception]
    first: Any
    last: frozenset[Any]
    diagram: Callable[[], str] | None = None


def drive_after(state: drive.DriveMode, event: drive.DriveInput) -> drive.DriveMode:
    unit = drive.DriveUnit()
    unit.mode = state
    unit.feed(event)
    return unit.mode


MACHINES = [
    Machine(
        "task", task.TABLE, task.State, task.LifecycleInput, task.after, task.IllegalTransition,
        task.State.WAITING, frozenset({task.State.KILLED}), task.diagram,
    ),
    Machine(
        "flow", flow.TABLE, flow.FlowState, flow.FlowEvent, flow.after, ValueError,
        flow.FlowState.READY, frozenset({flow.FlowState.ENDED}), flow.diagram,
    ),
    Machine(
        "link", link.CHANGES, link.LinkState, link.LinkEvent, link.follow, ValueError,
        link.LinkState.APART, frozenset({link.LinkState.ENDED}), link.diagram,
    ),
    Machine(
        "drive", drive.TABLE, drive.DriveMode, drive.DriveInput, drive_after, KeyError,
        drive.DriveMode.HELD, frozenset(),
    ),
]  # fmt: skip
PAIRS = [(machine, state, event) for machine in MACHINES for state in machine.states for event in machine.events]


def reached(machine, start):
    reachable, open_ = {start}, [start]
    while open_:
        for state in machine.table[open_.pop()].values():
            if state not in reachable:
                reachable.add(state)
                open_.append(state)
    return reachable


@pytest.mark.parametrize(("machine", "state", "event"), PAIRS, ids=lambda parameter: getattr(parameter, "name", None))
def test_every_event_in_every_state_is_in_the_table_or_refused_with_a_reason(machine, state, event):  # law 11
    if event in machine.table[state]:
        assert machine.after(state, event) is machine.table[state][event]
        assert machine.table[state][event] in machine.states
        return
    with pytest.raises(machine.refuses) as refused:
        machine.after(state, event)
    sentence = str(refused.value).lower()
    assert event.value in sentence or event.name.lower() in sentence
    assert state.value.lower() in sentence or state.name.lower() in sentence


@pytest.mark.parametrize("machine", MACHINES, ids=lambda parameter: parameter.name)
def test_every_state_stands_in_the_table_and_is_reached(machine):
    assert set(machine.table) == set(machine.states)
    assert reached(machine, machine.first) == set(machine.states)


@pytest.mark.parametrize("machine", MACHINES, ids=lambda parameter: parameter.name)
def test_every_event_means_something_somewhere(machine):
    assert {event for steps in machine.table.values() for event in steps} == set(machine.events)


@pytest.mark.parametrize("machine", MACHINES, ids=lambda parameter: parameter.name)
def test_the_end_is_reached_from_everywhere_and_never_left(machine):
    for state in machine.states:
        assert machine.last <= reached(machine, state)
    for state in machine.last:
        assert set(machine.table[state].values()) <= {state}


@pytest.mark.parametrize(
    "machine", [lifecycle for lifecycle in MACHINES if lifecycle.diagram], ids=lambda parameter: parameter.name
)
def test_the_diagram_is_the_table(machine):  # house, reading 8
    drawn = re.findall(r"^    (\S+) --> (\S+?) ?: (.+)$", machine.diagram(), re.MULTILINE)
    arrows = {(start, end, event) for start, end, event in drawn if start != "[*]"}
    edges = {
        (start.value, end.value, event.value)
        for start, steps in machine.table.items()
        for event, end in steps.items()
        if machine.name != "task" or start is not end
    }
    assert arrows == edges
