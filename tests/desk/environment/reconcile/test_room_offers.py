from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task
from onika.wire import act
from onika.words.reason import Reason

TASKS = tuple(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b"))


def test_where_there_is_one_unit_a_new_one_is_offered(tmp_path):  # R-A06, law 21
    duet = FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime(rtpus=("rt0",)))
    doc = duet.connected("a")
    duet.do(act.Turn(doc, ("a",), True))
    duet.runtime.tight = {"rt0"}
    duet.do(act.Place(doc, "b", 300, 40))
    line = next(say for say in duet.says if say.level == "error")
    assert line.text.key == "run.not_changed"
    assert line.remedies[0].label == Reason.of("desk.offer_new_unit", tasks=("b",), unit="rt1")
    assert [remedy.act for remedy in line.remedies] == [act.FindRoom(doc, "rt1"), act.FindRoom(doc)]


def test_what_fails_otherwise_has_no_other_way(tmp_path):  # R-X10
    duet = FakeRuntimeEnv(tmp_path, TASKS)
    doc = duet.connected("a")
    duet.runtime.lives["Untitled-1"].pop("a")  # so that killing it fails
    duet.do(act.Remove(doc, ("a",)))
    assert [say.remedies for say in duet.says if say.level == "error"] == [()]
    assert duet.document(doc).live.tight is None


def test_a_file_of_a_task_that_was_changed_with_it_leaves_the_message_alone(tmp_path):  # R-X10
    duet = FakeRuntimeEnv(tmp_path, TASKS)
    doc = duet.connected("a")
    duet.do(act.Turn(doc, ("a",), True))
    duet.runtime.tight = {"rt0"}
    duet.alias("a", "A", "OTHER")
    assert [say.remedies for say in duet.says if say.level == "error"] == [()]
