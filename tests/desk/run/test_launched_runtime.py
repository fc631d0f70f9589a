import os
import signal
import sys
import time
from types import SimpleNamespace

import pytest

from kit.plans.bell_plan import bell
from kit.plans.plan_builder import action
from kit.worlds.rail_world import rail_tasks
from onika.desk.run import launched_runtime as room
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.link.child.launcher import launch
from onika.link.lost import LinkLost
from onika.process.guard import is_stopped
from onika.wire import event, live, request
from onika.words.reason import Reason

pytestmark = pytest.mark.site


@pytest.fixture
def puppet(monkeypatch):
    """A runtime that is a few lines of Python."""

    def use(code):
        monkeypatch.setattr(room, "launch", lambda words, **how: launch(words, (sys.executable, "-c", code), **how))

    return use


def until(holds):
    """The system sends a signal, and does not say when it has come."""
    end = time.monotonic() + 30
    while not holds():
        assert time.monotonic() < end


def events_of(runtime):
    while True:
        for message in runtime.events(1.0):
            yield message
            if isinstance(message, event.Result):
                return


def test_a_runtime_that_does_not_answer_stop_is_ended():  # R-E10, law 27
    with pytest.raises(LinkLost) as lost, LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        os.kill(runtime.pid, signal.SIGSTOP)
        runtime.ask(request.Stop(Reason.plain("enough")))
    assert lost.value.reason.key == "link.frozen"


@pytest.mark.parametrize(("is_stopped", "said"), [(True, "link.frozen"), (False, "link.caught_in_call")])
def test_one_that_the_system_holds_in_a_call_is_called_frozen_all_the_same(is_stopped, said):  # R-E10
    child = SimpleNamespace(is_stopped=is_stopped, last_words=SimpleNamespace(task="flow0/puma"))
    assert room._unanswered(child).key == said


def test_a_runtime_is_asked_and_listened_to_until_the_block_ends():  # R-F01, reading 1
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        assert runtime.ask(request.Prepare(bell(), ())) == request.Prepared(())
        assert runtime.ask(request.Begin()) == request.Done()
        *_, result = events_of(runtime)
        assert result.completed
        pid = runtime.pid
    assert "ding" in runtime.printed()
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_a_simulator_that_rests_uses_no_processor_and_goes_on_where_it_was(monkeypatch):  # R-X25
    wall = [0]
    monkeypatch.setattr(room, "monotonic_ns", lambda: time.monotonic_ns() + wall[0])
    with LaunchedRuntime(("rt0",), is_virtual=True, options=("--scale", "1")) as runtime:
        assert runtime.rest()
        wall[0] += 3600 * 1_000_000_000
        until(lambda: is_stopped(runtime.pid))
        runtime.wake()
        assert runtime.ask(request.Prepare(bell(), ())) == request.Prepared(())
        assert runtime.is_heard


def test_a_runtime_that_is_left_while_it_rests_is_ended():  # R-A15, R-X25
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        pid = runtime.pid
        assert runtime.rest()
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_the_runtime_of_a_robot_never_rests(puppet):  # law 27
    puppet("import time; time.sleep(60)")
    runtime = LaunchedRuntime(("rt0",), is_virtual=False)
    assert not runtime.rest()
    runtime._child.close()


def test_names_and_kind_of_time_are_passed_on(puppet):
    puppet("import sys; print(sys.argv[1:], flush=True)")
    runtime = LaunchedRuntime(("rt0", "rt1"), is_virtual=True, with_fifo=False)
    with pytest.raises(LinkLost, match=r"'--rtpu', 'rt0', '--rtpu', 'rt1', '--virtual', '--no-fifo'"), runtime:
        pass


@pytest.mark.parametrize(
    ("code", "sentence"),
    [
        ("raise SystemExit('nothing works here')", r"ended with code 1; it printed last: nothing works here"),
        ("import os; os.kill(os.getpid(), 9)", r"was killed by signal 9"),
    ],
)
def test_a_runtime_that_ends_tells_how_and_what_it_printed_last(puppet, code, sentence):  # R-E10
    puppet(code)
    with pytest.raises(LinkLost, match=sentence), LaunchedRuntime(("rt0",), is_virtual=True):
        pass


WORDS = """
import sys
from onika.ring.last_words import LastWords
from onika.ring.segment import Segment
from onika.words.reason import Reason
words = LastWords(Segment.attach(int(sys.argv[sys.argv.index("--last-words") + 1])).view)
words.watch("flow0/sick")
"""


@pytest.mark.parametrize(
    ("code", "sentence"),
    [
        ("raise SystemExit(4)", "; it ended with code 4 in a call of task flow0/sick$"),
        ("import os; os.kill(os.getpid(), 9)", "; it was killed by signal 9 in a call of task flow0/sick$"),
        ("words.leave(Reason.plain('it had enough'))", "; it ended itself: it had enough$"),
    ],
)
def test_a_runtime_that_ends_in_a_call_tells_whose(puppet, code, sentence):  # R-E10
    puppet(WORDS + code)
    with pytest.raises(LinkLost, match=sentence), LaunchedRuntime(("rt0",), is_virtual=True):
        pass


def test_a_runtime_lost_in_the_middle_is_told(puppet):  # R-E10
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        os.kill(runtime.pid, signal.SIGKILL)
        with pytest.raises(LinkLost, match=r"the runtime is gone.*killed by signal 9"):
            for _ in events_of(runtime):
                pass
        with pytest.raises(LinkLost, match="the runtime is gone"):
            runtime.ask(request.Snapshot())


def test_faults_of_a_plan_come_back_over_the_link():  # R-E01
    plan = rail_tasks().plan([action("mass", "servo", arguments="99")])
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        faults = runtime.ask(request.Prepare(plan, ())).faults
    assert any("expected -9..9 m, found 99" in str(fault.reason) for fault in faults)
    assert any("DEVICE yard:m0" in str(fault.reason) for fault in faults)  # a world that this runtime has not


def test_what_is_sent_to_nobody_is_refused_and_the_end_is_told(puppet):  # R-E10
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        os.kill(runtime.pid, signal.SIGKILL)
        number, messages = runtime.send(live.Take("main")), []
        with pytest.raises(LinkLost, match="killed by signal 9"):
            while True:
                messages += runtime.messages(1.0)
    assert [message.number for message in messages] in ([], [number])
