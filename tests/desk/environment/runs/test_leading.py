"""A tool is led by a pad at a page: each push goes to the runtime, which judges it."""

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task
from onika.wire import act, live, request
from onika.words.reason import Reason

TASKS = (Task("a", "a", outvar=("A",), frequency=10.0),)
PUSH = act.Push((0.1, 0.0, 0.0, 0.0, 0.0, -0.2), True, scale=0.5, frame="tool", source="browser 2")


def test_a_push_goes_on_as_it_is_and_no_step_is_made_of_it(tmp_path):  # R-K07
    here = FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())
    here.rebuffs = {live.Push: request.Done()}
    doc = here.connected("a")
    before = here.environment.model.documents[doc]
    here.do(PUSH)
    expected = live.Push(PUSH.axes, True, False, 0.5, "tool", "", "browser 2")
    assert [asked for asked in here.carried_out if isinstance(asked, live.Push)] == [expected]
    assert here.environment.model.documents[doc] is before


def test_what_the_runtime_has_against_it_is_said(tmp_path):  # R-K07
    here = FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())
    here.connected("a")
    here.rebuffs = {live.Push: request.Refused(Reason.of("host.no_pad"))}
    assert "found none" in str(here.no(PUSH).reason)


def test_without_a_runtime_nobody_is_led(tmp_path):
    here = FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())
    assert here.no(PUSH).reason.key == "desk.no_robot"
