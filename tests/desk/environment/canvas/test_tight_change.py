import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, live, request
from onika.words.reason import Reason

TASKS = tuple(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b", "c"))


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


@pytest.fixture
def doc(duet):
    """A configuration in which `a` is ON, and `b` has found no gap between the cycles of rt0."""
    doc = duet.connected("a")
    duet.do(act.Turn(doc, ("a",), True))
    duet.runtime.tight = {"rt0"}
    duet.do(act.Place(doc, "b", 300, 40))
    assert duet.document(doc).content.names == ("a",)
    return doc


def remedies(duet):
    """The buttons beside the last message that something went wrong."""
    return [say for say in duet.says if say.level == "error"][-1].remedies


def test_units_and_a_moment_of_hold_are_offered_with_the_tasks_that_they_concern(duet, doc):  # law 21
    assert [(str(remedy.label), remedy.act) for remedy in remedies(duet)] == [
        ("Have b live on rt1", act.FindRoom(doc, "rt1")),
        ("In a moment of hold: a OFF, and ON again", act.FindRoom(doc)),
    ]


def test_in_a_moment_of_hold_it_is_placed_as_it_was_and_undo_takes_it_away(duet, doc):  # law 21, R-X10
    duet.do(act.FindRoom(doc))
    placed = duet.document(doc).content.placed("b")
    assert (placed.x, placed.y) == (300, 40) and duet.state(doc, "b") == "OFF"
    changes = [order for order in duet.runtime.asked if isinstance(order, live.Change)]
    assert (changes[-1].holds, changes[-2].holds) == (True, False)
    assert str(duet.document(doc).history.last.label) == "b once more, in a moment of hold"
    duet.do(act.Undo(doc))
    assert duet.document(doc).content.names == ("a",) and "b" not in duet.runtime.lives["Untitled-1"]


def test_on_another_unit_it_lives_there(duet, doc):  # R-A06, law 21
    duet.do(act.FindRoom(doc, "rt1"))
    assert duet.document(doc).content.placed("b").rtpu == "rt1" and duet.state(doc, "b") == "OFF"
    assert not [order for order in duet.runtime.asked if isinstance(order, live.AddUnit)]


def test_a_unit_that_does_not_live_is_started_first(duet, doc):  # R-A06, law 21
    duet.do(act.FindRoom(doc, "rt2"))
    assert [order for order in duet.runtime.asked if isinstance(order, live.AddUnit)] == [live.AddUnit("rt2")]
    assert duet.document(doc).content.placed("b").rtpu == "rt2"
    assert "rt2" in duet.environment.model.runtime.units


def test_where_the_unit_does_not_come_nothing_changes(duet, doc):  # R-X01
    duet.rebuffs = {live.AddUnit: request.Refused(Reason.of("host.units_many", most=8))}
    assert duet.answer(act.FindRoom(doc, "rt9")).no.reason.key == "host.units_many"
    assert duet.document(doc).content.names == ("a",)


def test_where_the_canvas_has_changed_there_is_nothing_to_do_again(duet, doc):
    duet.do(act.Move(doc, {"a": (70, 70)}))
    assert duet.answer(act.FindRoom(doc)).no.reason.key == "desk.nothing_without_gap"


def test_once_done_there_is_nothing_to_do_again(duet, doc):  # law 21
    duet.do(act.FindRoom(doc))
    assert duet.answer(act.FindRoom(doc)).no.reason.key == "desk.nothing_without_gap"


def test_code_that_finds_no_gap_offers_a_moment_of_hold_alone(duet):  # R-X15, law 21
    doc = duet.connected("a")
    duet.do(act.Turn(doc, ("a",), True))
    duet.runtime.tight = {"rt0"}
    duet.do(act.Renew(doc, "a"))
    assert [remedy.act for remedy in remedies(duet)] == [act.Renew(doc, "a", holds=True)]
    duet.do(act.Renew(doc, "a", holds=True))
    assert [order.holds for order in duet.runtime.asked if isinstance(order, live.Swap)] == [False, True]
