import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task
from onika.wire import act, event, live, request
from onika.words.reason import Reason

TASKS = (Task("a", "a", outvar=("A",), frequency=10.0), Task("b", "b", outvar=("B",), frequency=10.0))


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())


def test_a_module_is_told_a_value_by_name_and_asked_for_it(duet):  # R-A05
    doc = duet.connected("a")
    duet.do(act.TellModule(doc, "a", "gain", "2.5"))
    assert duet.do(act.AskModule(doc, "a", "gain")) == "2.5"
    asked = [message for message in duet.carried_out if isinstance(message, live.Get | live.Set)]
    assert asked == [live.Set("Untitled-1", "a", "gain", "2.5"), live.Get("Untitled-1", "a", "gain")]


def test_a_number_that_a_module_says_comes_whole(duet):  # R-A05
    doc = duet.connected("a")
    duet.rebuffs = {live.Get: live.Value([0.1, 1 / 3])}
    assert duet.do(act.AskModule(doc, "a", "gain")) == "0.1 0.3333333333333333"


def test_what_a_module_does_not_offer_is_refused_with_its_words(duet):  # R-A05
    doc = duet.connected("a")
    assert "nothing called 'gain'" in str(duet.no(act.AskModule(doc, "a", "gain")).reason)
    assert "b" in str(duet.no(act.AskModule(doc, "b", "gain")).reason)


def test_who_only_watches_may_ask_a_module_and_not_tell_it(duet):  # R-A05, law 27
    doc = duet.connected("a")
    duet.do(act.TellModule(doc, "a", "gain", "2"))
    duet.tell(event.Held("Untitled-1", "Anna"))
    refused = duet.no(act.TellModule(doc, "a", "gain", "3"))
    assert "Anna" in str(refused.reason) and refused.remedies[0].act == act.Take(doc)
    assert duet.do(act.AskModule(doc, "a", "gain")) == "2"


def test_the_memory_of_variables_is_checked(duet):  # R-A12
    doc = duet.connected("a")
    assert duet.do(act.CheckMemory(doc)) == ()
    duet.runtime.findings = {"Untitled-1": ("A: the guard behind it was overwritten",)}
    assert list(map(str, duet.do(act.CheckMemory(doc)))) == ["A: the guard behind it was overwritten"]


def test_present_readings_are_lines_of_a_log(duet):  # R-A12
    doc = duet.connected("a")
    duet.runtime.variables = {"Untitled-1": {"A": [0.1, 2.0], "NAME": "PUMA 560"}}
    duet.runtime.now_s = 1.5
    head, *lines = duet.do(act.LogReadings(doc)).splitlines()
    assert head.startswith("#")
    assert lines == ["1.500000 Untitled-1 A double[2] 0.1 2.0", '1.500000 Untitled-1 NAME string "PUMA 560"']


def test_what_is_not_connected_has_no_memory_to_look_into_and_a_runtime_says_why_not(duet):
    doc = duet.new("a")
    for asked in (act.AskModule(doc, "a", "x"), act.CheckMemory(doc), act.LogReadings(doc)):
        assert duet.no(asked).remedies[0].act == act.Connect(doc)
    duet.do(act.Connect(doc))
    duet.rebuffs = {kind: request.Refused(Reason.plain("not now")) for kind in (live.Check, live.Read)}
    assert str(duet.no(act.CheckMemory(doc)).reason) == "not now"
    assert str(duet.no(act.LogReadings(doc)).reason) == "not now"


def test_a_variable_is_written_by_hand_by_who_holds_it(duet):  # R-C27, law 27
    doc = duet.connected("a")
    duet.do(act.WriteVariable(doc, "B", (0.5, 1.0)))
    assert [message for message in duet.carried_out if isinstance(message, live.Write)] == [
        live.Write("Untitled-1", "B", (0.5, 1.0))
    ]
    duet.rebuffs = {live.Write: request.Refused(Reason.plain("A is written by a"))}
    assert str(duet.no(act.WriteVariable(doc, "A", (1.0,))).reason) == "A is written by a"
    duet.tell(event.Held("Untitled-1", "Anna"))
    assert duet.no(act.WriteVariable(doc, "B", (1.0,))).remedies[0].act == act.Take(doc)
    assert duet.no(act.WriteVariable(duet.new("b"), "B", (1.0,))).remedies[0].label.key == "desk.connect_it"
