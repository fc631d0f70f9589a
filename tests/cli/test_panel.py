import io

import pytest
from rich.console import Console

from onika.cli.panel import FLOWS, MARKS, Panel
from onika.cli.typed_input.key_bindings import KEYS
from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.engine.flow import FlowState
from onika.model.lifecycle import State
from onika.wire import event
from onika.wire.steer import Position

ONE = FlowIndex((IndexedFlow("flow0", ("lift", "turn", "drop")),))
TWO = FlowIndex((*ONE.parts, IndexedFlow("flow1", ("wait",))))


def shown(panel, width=120):
    out = Console(file=io.StringIO(), width=width, color_system=None, highlight=False)
    out.print(panel.draw())
    return out.file.getvalue()


@pytest.fixture
def panel():
    panel_ = Panel()
    panel_.begins("assemble", TWO)
    return panel_


def test_before_the_run_it_says_that_it_prepares():
    assert "preparing" in shown(Panel())


def test_each_flow_is_a_line_with_its_state_its_place_and_its_action(panel):  # R-E11
    panel.happens(event.Began(0, 1, 3, "turn", 0.5))
    panel.happens(event.Moved("flow0", "running", 1, 0.5))
    panel.happens(event.Moved("flow1", "waiting", -1, 0.5, "t a", ("flow0",)))
    head, first, second = shown(panel).splitlines()[1:4]
    assert head.startswith("assemble  0.")
    assert first.startswith(" 0 flow0")
    assert "2/3  ▶ running  turn" in first
    assert "0/1  ⧗ waiting  waits at a for flow0" in second


def test_a_pause_to_come_and_loops_are_shown_as_the_runtime_says(panel):  # R-E07, R-E05
    panel.place((Position("flow0", "running", 0, is_pausing=True, loops=("outer", "inner")),))
    text = shown(panel)
    assert "▶ will pause  lift  ↺ outer ↺ inner" in text


def test_the_chosen_flow_is_marked(panel):  # R-E07
    panel.bindings.press("1")
    assert "›1 flow1" in shown(panel)


def test_keys_are_offered_only_where_there_is_a_keyboard(panel):  # R-E07
    assert "p pause" not in shown(panel)
    panel.has_keys = True
    assert "p pause" in shown(panel)
    panel.bindings.press("?")
    text = " ".join(shown(panel, 200).split())
    assert all(f"{key} {meaning}" in text for key, (_, meaning) in KEYS.items())
    assert "0-9 choose a flow" in text
    panel.bindings.press(":")
    panel.bindings.press("s")
    assert ": s▏" in shown(panel)


def test_with_one_flow_its_name_says_nothing():
    panel = Panel()
    panel.begins("go_home", ONE)
    panel.happens(event.TaskState("flow0", "pd", "ON", 0.0))
    text = shown(panel)
    assert "flow0" not in text
    assert "▶ pd" in text


def test_tasks_that_are_gone_are_not_shown(panel):
    panel.happens(event.TaskState("flow0", "pd", "ON", 0.0))
    panel.happens(event.TaskState("flow1", "pd", "KILLED", 0.0))
    text = shown(panel)
    assert "▶ flow0/pd" in text
    assert "flow1/pd" not in text


def test_every_state_has_a_mark():
    assert set(FLOWS) == {state.value for state in FlowState}
    assert set(MARKS) == {state.value for state in State} - {"KILLED"}


def test_a_small_terminal_is_enough(panel):
    panel.has_keys = True
    assert max(len(line) for line in shown(panel, 60).splitlines()) <= 60


def test_each_flow_keeps_to_one_line_however_much_there_is_to_say(panel):  # R-E11
    loops = tuple(f"loop_number_{number}" for number in range(9))
    panel.place((Position("flow0", "running", 0, loops=loops),))
    lines = shown(panel, 80).splitlines()
    assert lines[2].rstrip().endswith("…")
    assert lines[3].startswith(" 1 flow1")
