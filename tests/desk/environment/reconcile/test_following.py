import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import LocalLine, Task
from onika.wire import act, event, live

TASKS = (
    Task("source", "source", outvar=("X",), frequency=10.0),
    Task("filter", "filter", invar=("X",), outvar=("Y",), frequency=10.0),
    Task("other", "other", outvar=("Z",), frequency=10.0),
    Task("arm", "arm", invar=("Y",), frequency=100.0, local=(LocalLine("DEVICE", ("boxes:arm",)),)),
)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def test_placing_spawns_and_removing_kills_each_with_its_undo(duet):  # R-C11, R-X10
    doc = duet.connected("source")
    duet.do(act.Place(doc, "filter", 300, 0))
    assert duet.state(doc, "filter") == "OFF" and set(duet.runtime.lives["Untitled-1"]) == {"source", "filter"}
    duet.do(act.Remove(doc, ("source",)))
    assert set(duet.runtime.lives["Untitled-1"]) == {"filter"}
    duet.do(act.Undo(doc))
    assert set(duet.runtime.lives["Untitled-1"]) == {"source", "filter"}
    duet.do(act.Undo(doc))
    assert set(duet.runtime.lives["Untitled-1"]) == {"source"}
    duet.do(act.Redo(doc))
    assert set(duet.runtime.lives["Untitled-1"]) == {"source", "filter"}


def test_several_at_once_are_one_change(duet):  # R-X10
    doc = duet.connected("source", "filter", "other")
    before = len(duet.edits())
    duet.do(act.Remove(doc, ("source", "filter", "other")))
    assert [edit.kill for edit in duet.edits()[before:]] == [("source", "filter", "other")]


def test_moving_an_icon_asks_nothing_of_the_runtime(duet):  # R-X09
    doc = duet.connected("source")
    before = len(duet.carried_out)
    duet.do(act.Move(doc, {"source": (5, 5)}))
    assert len(duet.carried_out) == before


def test_an_icon_that_takes_anothers_place_takes_its_life_in_one_change(duet):  # R-C15
    doc = duet.connected("source")
    duet.do(act.Exchange(doc, "source", "other"))
    last = duet.edits()[-1]
    assert last.kill == ("source",) and [task.name for task in last.spawn] == ["other"]


def test_a_changed_alias_reaches_the_living_task_in_every_document(duet):  # R-C04, reading 9
    doc = duet.connected("source")
    duet.do(act.Toggle(doc, "source"))
    duet.alias("source", "X", "W")
    last = duet.edits()[-1]
    assert last.kill == ("source",) and last.spawn[0].aliases == (("X", "W"),) and last.on == (live.Turn("source"),)
    assert duet.state(doc, "source") == "ON"


def test_hardware_is_not_switched_on_again_by_an_exchange(duet):  # law 12
    doc = duet.connected("arm")
    duet.do(act.Toggle(doc, "arm"))
    duet.alias("arm", "Y", "W")
    assert duet.state(doc, "arm") == "OFF"
    assert any("stays OFF until you turn it on" in str(say.text) for say in duet.says)


def test_undo_asks_before_anything_comes_on_again(duet):  # law 22
    doc = duet.connected("arm")
    duet.do(act.Toggle(doc, "arm"))
    duet.do(act.Toggle(doc, "arm"))
    refused = duet.no(act.Undo(doc))
    assert "arm" in str(refused.reason)
    duet.do(refused.remedies[0].act)
    assert duet.state(doc, "arm") == "ON"


def test_what_cannot_live_is_refused_and_nothing_is_changed(duet, tmp_path):  # R-X01
    doc = duet.connected("source")
    (tmp_path / "module" / "other.py").unlink()
    assert str(duet.no(act.Place(doc, "other", 0, 0)).reason).startswith("other cannot live")


def test_a_stopped_runtime_lets_nobody_live_but_whom_it_has_may_go(duet):  # law 27
    doc = duet.connected("source")
    duet.do(act.Stop())
    refused = duet.no(act.Place(doc, "filter", 0, 0))
    assert refused.remedies[0].act == act.Reset()
    duet.do(act.Remove(doc, ("source",)))


def test_what_is_held_by_another_can_be_looked_at_only(duet):  # R-X12
    doc = duet.connected("source")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    refused = duet.no(act.Remove(doc, ("source",)))
    assert "held by anna#2" in str(refused.reason) and refused.remedies[0].act == act.Take(doc)


def test_what_nobody_here_shows_any_more_may_be_held_by_others(duet):  # R-X12
    doc = duet.connected("source")
    duet.do(act.Close(doc, discards=True, alive="leave"))
    assert isinstance(duet.carried_out[-1], live.Release)
    assert set(duet.runtime.lives["Untitled-1"]) == {"source"}


def test_a_document_that_is_not_connected_asks_nothing_of_anybody(duet):
    doc = duet.new("source", "filter")
    duet.do(act.Undo(doc))
    assert not duet.carried_out
