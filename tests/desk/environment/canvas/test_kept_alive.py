import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.labs.laboratory import Laboratory
from onika.model.lifecycle import State
from onika.model.task import Task
from onika.wire import act

WAVE = Task("wave", "wave", outvar=("W",), frequency=20.0)
TONE = Task("tone", "tone", outvar=("W",), frequency=20.0)
CALM = Task("calm", "calm", invar=("W",), outvar=("C",), frequency=20.0)
TWIN = Task("twin", "wave", outvar=("V",), frequency=20.0)


@pytest.fixture
def desk(tmp_path):
    desk = FakeRuntimeEnv(tmp_path, (WAVE, TONE, CALM, TWIN))
    lab = Laboratory(tmp_path)
    lab.configuration("pairC", "wave 20", "calm 20")
    lab.configuration("otherC", "calm 50", "tone 20")
    lab.configuration("twinC", "twin 20")
    lab.configuration("lostC", "nobody 20")
    return desk


def path(desk, name):
    return str(desk.base.configuration_file(name))


def both(desk):
    """pairC is shown, its tasks are ON, and otherC is kept alive."""
    doc = desk.do(act.Open(path(desk, "pairC")))
    desk.do(act.Connect(doc))
    desk.do(act.Turn(doc, ("wave", "calm"), True))
    desk.do(act.KeepAlive(doc, path(desk, "otherC")))
    return doc


def states(desk, doc):
    return {name: facts.state for name, facts in desk.document(doc).live.tasks.items()}


def shown(desk, doc):
    return desk.environment.tree.documents[doc]


def test_the_union_of_configurations_lives_and_what_is_not_shown_rests(desk):  # R-C32
    doc = both(desk)
    assert states(desk, doc) == {"wave": "ON", "calm": "ON", "tone": "OFF"}
    assert sorted(shown(desk, doc).tasks) == ["calm", "wave"]
    assert shown(desk, doc).kept["otherC"].tasks == {"calm": "ON", "tone": "OFF"}


def test_one_act_switches_and_what_both_have_is_not_touched(desk):  # R-C32, R-A13
    doc = both(desk)
    before = len(desk.edits())
    desk.do(act.SwitchTo(doc, "otherC"))
    assert states(desk, doc) == {"wave": "OFF", "calm": "ON", "tone": "ON"}
    (change,) = desk.edits()[before:]
    assert (change.off, [turn.task for turn in change.on]) == (("wave",), ["tone"])
    assert change.kill == change.spawn == () and change.rates == (("calm", 50.0),)
    assert (shown(desk, doc).name, list(shown(desk, doc).kept)) == ("otherC", ["pairC"])
    assert (shown(desk, doc).path, shown(desk, doc).is_dirty) == (path(desk, "otherC"), False)
    desk.do(act.SwitchTo(doc, "pairC"))
    assert states(desk, doc) == {"wave": "ON", "calm": "ON", "tone": "OFF"}
    assert desk.edits()[-1].rates == (("calm", 20.0),)


def test_a_switch_is_taken_back_after_a_question_for_it_turns_tasks_on(desk):  # R-C32, R-X10
    doc = both(desk)
    desk.do(act.SwitchTo(doc, "otherC"))
    no = desk.no(act.Undo(doc))
    desk.do(no.remedies[0].act)
    assert states(desk, doc) == {"wave": "ON", "calm": "ON", "tone": "OFF"}
    assert (shown(desk, doc).name, shown(desk, doc).path) == ("pairC", path(desk, "pairC"))
    desk.do(act.Undo(doc))  # the keeping alive
    assert states(desk, doc) == {"wave": "ON", "calm": "ON"} and shown(desk, doc).kept == {}
    desk.do(act.Redo(doc))
    assert states(desk, doc) == {"wave": "ON", "calm": "ON", "tone": "OFF"}


def test_letting_go_ends_what_no_other_has(desk):  # R-C32
    doc = both(desk)
    desk.do(act.LetGo(doc, "otherC"))
    assert states(desk, doc) == {"wave": "ON", "calm": "ON"} and shown(desk, doc).kept == {}
    assert "none is" in str(desk.no(act.LetGo(doc, "otherC")).reason)


def test_what_was_changed_on_the_canvas_comes_back_with_its_configuration_and_is_not_lost(desk):  # R-C32, R-X10
    doc = both(desk)
    desk.do(act.Rate(doc, "wave", 40.0))
    desk.do(act.SwitchTo(doc, "otherC"))
    assert shown(desk, doc).kept["pairC"].is_dirty
    assert desk.no(act.Close(doc)).reason.key == "run.is_not_saved"
    no = desk.no(act.LetGo(doc, "pairC"))
    assert [remedy.act for remedy in no.remedies] == [
        act.SwitchTo(doc, "pairC"),
        act.LetGo(doc, "pairC", discards=True),
    ]
    desk.do(act.SwitchTo(doc, "pairC"))
    assert shown(desk, doc).tasks["wave"].hz == 40.0


def test_a_task_that_leaves_the_canvas_and_is_kept_rests(desk):  # R-C32
    doc = both(desk)
    desk.do(act.Remove(doc, ("calm",)))
    assert states(desk, doc) == {"wave": "ON", "calm": "OFF", "tone": "OFF"}


def test_what_cannot_live_beside_the_others_is_refused_in_words(desk):  # R-C32, R-X01
    doc = both(desk)
    assert "wave" in str(desk.no(act.KeepAlive(doc, path(desk, "twinC"))).reason)
    assert "alive here already" in str(desk.no(act.KeepAlive(doc, path(desk, "otherC"))).reason)
    assert "no open library has nobody" in str(desk.no(act.KeepAlive(doc, path(desk, "lostC"))).reason)
    assert "not kept alive here; there are otherC" in str(desk.no(act.SwitchTo(doc, "twinC")).reason)
    unconnected = desk.new("twin")
    assert desk.no(act.KeepAlive(unconnected, path(desk, "pairC"))).remedies[0].act == act.Connect(unconnected)


def test_a_task_in_error_hinders_the_switch_and_can_be_cleared(desk):  # R-C32, R-C28
    doc = both(desk)
    home = desk.document(doc).live.subsystem
    desk.runtime.turn(home, "tone", State.ERROR)
    desk.hear()
    no = desk.no(act.SwitchTo(doc, "otherC"))
    assert (no.reason.key, no.remedies[0].act) == ("desk.kept_failed", act.Clear(doc, "tone"))


def test_leaving_the_runtime_keeps_nothing_alive_for_the_document(desk):  # R-C32, R-C12
    doc = both(desk)
    desk.do(act.Disconnect(doc))
    assert shown(desk, doc).kept == {}


def test_a_refused_switch_leaves_everything_as_it_was(desk):  # R-C32, R-X10
    doc = both(desk)
    desk.runtime.refusals["Change"] = "not now"
    answer = desk.answer(act.SwitchTo(doc, "otherC"))
    assert answer.no is not None
    assert states(desk, doc) == {"wave": "ON", "calm": "ON", "tone": "OFF"}
    assert (shown(desk, doc).name, shown(desk, doc).path) == ("pairC", path(desk, "pairC"))
    assert list(shown(desk, doc).kept) == ["otherC"]
