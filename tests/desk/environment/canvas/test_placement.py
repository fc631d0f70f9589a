from dataclasses import replace

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.task import LocalLine, Task
from onika.wire import act

TASKS = (
    Task("cubic", "cubic", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("trapez", "trapez", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", inconst=("KP",), invar=("Q_REF", "Q_MEZ"), outvar=("TAU",), frequency=100.0),
    Task("robot", "robot", outconst=("KP",), invar=("TAU",), outvar=("Q_MEZ",), frequency=100.0),
)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, TASKS)


def document(sitting, doc="c1"):
    return sitting.environment.tree.documents[doc]


def test_a_placed_task_stands_where_it_was_put_and_is_connected_by_names(sitting):  # R-C09
    doc = sitting.new("cubic", "pd")
    assert (document(sitting).tasks["pd"].x, document(sitting).tasks["pd"].y) == (200, 100)
    locus = document(sitting).loci["Q_REF"]
    assert (locus.writers, locus.readers) == (("cubic",), ("pd",))
    assert doc == "c1"


def test_what_may_not_join_is_greyed_with_its_reason_and_refused_with_the_same(sitting):  # R-C07, R-X01
    doc = sitting.new("cubic")
    (reason,) = document(sitting).greyed["trapez"]
    refused = sitting.no(act.Place(doc, "trapez", 0, 0))
    assert str(reason.text) in str(refused.reason)
    assert refused.remedies == reason.remedies


def test_the_remedy_of_a_refusal_does_what_it_says(sitting):  # R-X01
    doc = sitting.new("cubic", "pd")
    remedy = sitting.no(act.Place(doc, "trapez", 0, 0)).remedies[0]
    sitting.do(remedy.act)
    tasks = document(sitting).tasks
    assert sorted(tasks) == ["pd", "trapez"]
    assert (tasks["trapez"].x, tasks["trapez"].y) == (0, 100)


def test_several_things_are_moved_as_one_step(sitting):  # R-C10, R-X10
    doc = sitting.new("cubic", "pd")
    before = document(sitting)
    sitting.do(act.Move(doc, {"cubic": (5, 6), "pd": (7, 8)}, {"Q_REF": (50, 60)}))
    moved = document(sitting)
    assert (moved.tasks["cubic"].x, moved.tasks["pd"].y, moved.loci["Q_REF"].x) == (5, 8, 50)
    sitting.do(act.Undo(doc))
    assert (document(sitting).tasks, document(sitting).loci) == (before.tasks, before.loci)


def test_loci_stay_when_tasks_move(sitting):  # R-C24
    doc = sitting.new("cubic", "pd")
    before = document(sitting).loci["Q_REF"]
    sitting.do(act.Move(doc, {"cubic": (500, 600)}))
    assert document(sitting).loci["Q_REF"] == before


def test_a_flip_turns_the_icon_and_back(sitting):  # R-C10
    doc = sitting.new("cubic")
    sitting.do(act.Flip(doc, ("cubic",)))
    assert not document(sitting).tasks["cubic"].in_left
    sitting.do(act.Flip(doc, ("cubic",)))
    assert document(sitting).tasks["cubic"].in_left


def test_connections_are_hidden_and_shown(sitting):  # R-C09
    doc = sitting.new("cubic", "pd")
    sitting.do(act.Show(doc, ("Q_REF",), False))
    assert not document(sitting).loci["Q_REF"].is_shown
    sitting.do(act.Show(doc, ("Q_REF",), True))
    assert document(sitting).loci["Q_REF"].is_shown


def test_removing_takes_the_loci_of_nobody_along(sitting):  # R-C24
    doc = sitting.new("cubic", "pd")
    sitting.do(act.Remove(doc, ("cubic", "pd")))
    assert (document(sitting).tasks, document(sitting).loci) == ({}, {})
    sitting.do(act.Undo(doc))
    assert sorted(document(sitting).tasks) == ["cubic", "pd"]


@pytest.mark.parametrize(
    ("edge", "corners"),
    [
        ("left", [(10, 20), (10, 300), (10, 80)]),
        ("right", [(400, 20), (400, 300), (400, 80)]),
        ("top", [(10, 20), (100, 20), (400, 20)]),
        ("columns", [(10, 20), (205, 300), (400, 80)]),
        ("rows", [(10, 20), (100, 300), (400, 160)]),
    ],
)
def test_tasks_are_brought_onto_one_line(sitting, edge, corners):
    doc = sitting.new("cubic", "pd", "robot")
    names = ("cubic", "pd", "robot")
    sitting.do(act.Move(doc, {"cubic": (10, 20), "pd": (100, 300), "robot": (400, 80)}))
    sitting.do(act.Align(doc, names, edge))
    tasks = document(sitting).tasks
    assert [(tasks[name].x, tasks[name].y) for name in names] == corners


def test_their_lower_edges_are_aligned_whatever_their_heights(sitting):
    doc = sitting.new("cubic", "pd")
    sitting.do(act.Move(doc, {"cubic": (10, 20), "pd": (100, 300)}))
    sitting.do(act.Align(doc, ("cubic", "pd"), "bottom"))
    tasks, catalogue = document(sitting).tasks, sitting.environment.tree.tasks
    assert len({tasks[name].y + catalogue[name].height for name in tasks}) == 1


@pytest.mark.parametrize(
    "wish",
    [
        act.Place("c9", "pd", 0, 0),
        act.Place("c1", "nobody", 0, 0),
        act.Exchange("c1", "nobody", "pd"),
        act.Remove("c1", ("nobody",)),
        act.Move("c1", {"nobody": (0, 0)}),
        act.Move("c1", {}, {"NOTHING": (0, 0)}),
        act.Flip("c1", ("nobody",)),
        act.Align("c1", ("nobody",), "left"),
    ],
)
def test_what_is_not_there_is_refused_by_name(sitting, wish):
    sitting.new("cubic")
    reason = str(sitting.no(wish).reason)
    assert "nobody" in reason or "NOTHING" in reason or "no longer open" in reason


def test_nothing_is_placed_farther_out_than_it_could_be_found_again(sitting):
    doc = sitting.new()
    sitting.do(act.Place(doc, "pd", 10**12, -(10**12)))
    assert (document(sitting).tasks["pd"].x, document(sitting).tasks["pd"].y) == (100_000, -100_000)


def test_a_task_that_replaces_another_takes_its_place_in_its_supermodule(sitting):  # R-C17
    doc = sitting.new("cubic", "pd")
    sitting.do(act.Group(doc, "arm", ("pd", "cubic")))
    sitting.do(act.Exchange(doc, "cubic", "trapez"))
    sitting.do(act.Move(doc, {"pd": (9, 9)}))
    assert document(sitting).groups["arm"].tasks == ("pd", "trapez")


def test_a_configuration_is_arranged_as_one_step_that_is_taken_back(sitting):  # R-C09, R-X10
    doc = sitting.new("pd", "cubic")
    before = sitting.environment.model.documents[doc].content
    sitting.do(act.Arrange(doc))
    tasks = document(sitting).tasks
    assert tasks["cubic"].x < tasks["pd"].x
    assert str(document(sitting).undo) == "arranging Untitled-1"
    sitting.do(act.Undo(doc))
    assert sitting.environment.model.documents[doc].content == before
    assert "ghost" in str(sitting.no(act.Arrange(doc, ("ghost",))).reason)


def test_what_is_known_to_be_hardware_stands_first(tmp_path):  # law 1
    arm = replace(TASKS[3], local=(LocalLine("DEVICE", ("boxes:arm",)),))
    sitting = EnvironmentFixture(tmp_path, (*TASKS[:3], arm))
    doc = sitting.new("pd", "cubic", "robot")
    sitting.do(act.Arrange(doc))
    tasks = document(sitting).tasks
    assert tasks["robot"].x < tasks["cubic"].x < tasks["pd"].x
