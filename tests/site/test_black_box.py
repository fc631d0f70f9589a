"""The last seconds of what goes badly, a run or by hand, in real processes (requirement X05)."""

import os
import signal
import stat
from contextlib import suppress
from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.plans.plan_builder import PlanBuilder
from kit.process.cli_process import CliProcess
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.run_review import Review
from onika.desk.run.runtime_conversation import black_box_in
from onika.link.lost import LinkLost
from onika.record.black_box_folder import black_box_folder, black_boxes
from onika.wire import event, live

pytestmark = pytest.mark.site

ARM = ("puma 500", "diff 500", "gravcomp 250", "pd 500", "torque_sum 500", "led_monitor 50")


def program(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.configuration("moveC", *ARM, "jtraj 250")
    move = job("moveC", "Joint job")
    near = joints("near", 0.05, -1.57, 1.57, 0.0, 0.0, 0.0, duration=1.0)
    there = joints("there", 1.0, -1.57, 1.57, 0.0, 0.0, 0.0, duration=20.0)
    return str(laboratory.application("move", [move, near, move, there]))


@pytest.fixture
def state(tmp_path):
    return {"XDG_STATE_HOME": str(tmp_path / "state")}


def boxes(state):
    return black_boxes(black_box_folder(state))


def assert_last_seconds(path):
    """An ordinary recording that reads to its end, whose last values are those of the moment."""
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    with Review(path) as review:
        assert review.is_whole
        assert review.ending["completed"] == "no"
        position = review.series["flow0/Q_MEZ"]
        times = [at for at, _ in position.values()]
        assert len(set(times)) > 10
        assert review.span_s[1] - times[-1] * 1e-9 < 0.5
        return review.ending["cause"]


def test_a_killed_processing_unit_leaves_a_black_box_that_the_result_names(tmp_path, state):  # R-X05, law 17
    with CliProcess("run", program(tmp_path), "--json", environment=state) as console:
        console.until(event="began", index=1)
        os.kill(console.process("onika.host.units.rtpu"), signal.SIGKILL)
        result = console.result()
        assert console.code() == 1
        assert console.left_over() == []
    assert [str(path) for path in boxes(state)] == [result["black_box"]]
    assert "signal 9" in assert_last_seconds(Path(result["black_box"]))


def test_a_killed_runtime_leaves_a_black_box_that_the_result_names(tmp_path, state):  # R-X05
    with CliProcess("run", program(tmp_path), "--json", environment=state) as console:
        console.until(event="began", index=1)
        os.kill(console.process("onika.host --link-fd"), signal.SIGKILL)
        result = console.result()
        assert console.code() == 1
        assert console.left_over() == []
    assert [str(path) for path in boxes(state)] == [result["black_box"]]
    assert assert_last_seconds(Path(result["black_box"])) == "the runtime program has died"


COUNTER = """
from onika.module import Module, OutVar

class Counter(Module):
    COUNT = OutVar("double", "-", "how many cycles")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
"""
_TURNS = 600
"""How often is listened at most; each time up to a tenth of a second."""


class HandHeld:
    """A task that is ON by hand on a runtime of its own, and counts."""

    def __init__(self, runtime):
        self.runtime = runtime
        self.events = []
        shop = PlanBuilder()
        shop.task("counter", COUNTER, frequency=100.0)
        runtime.ask(live.Attend(("*",)))
        on = (live.Turn("counter"),)
        runtime.ask(live.Change("jog", spawn=(shop.planned("counter"),), code=(shop.code("counter"),), on=on))
        self.until(lambda message: isinstance(message, event.TaskState) and message.state == "ON")
        while runtime.ask(live.Read("jog", ("COUNT",))).values["COUNT"] < 100:  # the box's process may come up late
            self.events += runtime.events(0.1)

    def until(self, is_it):
        """The first event that is meant."""
        for _ in range(_TURNS):
            meant = [message for message in self.events if is_it(message)]
            if meant:
                return meant[0]
            self.events += self.runtime.events(0.1)
        raise AssertionError(f"not among {self.events[-20:]}")


def child_of(pid, name):
    """The process id of a process that this one has started."""
    for entry in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            words = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode()
            parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            if parent == pid and name in words:
                return int(entry.name)
    raise AssertionError(f"{pid} has no process {name}")


def assert_of_the_counter(path):
    with Review(path) as review:
        assert review.is_whole
        assert review.run.is_by_hand
        assert len({at for at, _ in review.series["jog/COUNT"].values()}) > 10
        return review.ending["cause"]


def test_a_killed_unit_leaves_a_black_box_of_what_is_on_by_hand(state, monkeypatch):  # R-X05, law 17
    monkeypatch.setenv("XDG_STATE_HOME", state["XDG_STATE_HOME"])
    with LaunchedRuntime(("rt0",), is_virtual=False) as runtime:
        hand_held = HandHeld(runtime)
        os.kill(child_of(runtime.pid, "onika.host.units.rtpu"), signal.SIGKILL)
        kept = hand_held.until(lambda message: isinstance(message, event.LastSecondsKept))
        assert (kept.subsystem, kept.run) == ("jog", "")
    assert [str(path) for path in boxes(state)] == [kept.path]
    assert "signal 9" in assert_of_the_counter(Path(kept.path))


def test_a_killed_runtime_leaves_a_black_box_of_what_is_on_by_hand(state, monkeypatch):  # R-X05
    monkeypatch.setenv("XDG_STATE_HOME", state["XDG_STATE_HOME"])
    with pytest.raises(LinkLost) as lost, LaunchedRuntime(("rt0",), is_virtual=False) as runtime:
        hand_held = HandHeld(runtime)
        os.kill(runtime.pid, signal.SIGKILL)
        hand_held.until(lambda _message: False)
    (path,) = boxes(state)
    assert black_box_in(lost.value.reason) == str(path)
    assert assert_of_the_counter(path) == "the runtime program has died"
