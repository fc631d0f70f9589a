import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, live

A = Task("a", "a", outvar=("Q",), frequency=10.0)


def test_acts_are_carried_out_by_the_runtime_and_answered_once(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, (A,))
    doc = duet.connected("a")
    assert duet.state(doc, "a") == "OFF"
    assert [edit.subsystem for edit in duet.edits()] == ["Untitled-1"]


def test_an_act_whose_order_is_held_back_has_no_answer_yet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, (A,))
    doc = duet.connected("a")
    duet.is_held_back = True
    with pytest.raises(AssertionError, match="answered 0 times"):
        duet.do(act.Toggle(doc, "a"))
    duet.is_held_back = False
    duet.pump()
    assert isinstance(duet.carried_out[-2], live.Change) and duet.state(doc, "a") == "ON"
