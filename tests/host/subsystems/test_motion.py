import pytest

from onika.host.subsystems.desired_state import DesiredState
from onika.host.subsystems.motion import Motion
from onika.wire import event
from onika.words.reason import NOTHING, Reason

WHY = Reason.plain("a hand in the cell")


class Runtime:
    """A driver, two runs and two subsystems held by hand; everything that is done to them, in order."""

    now = 70

    def __init__(self):
        self.acts = []
        self.runs = [Run(self.acts, "a"), Run(self.acts, "b")]
        self.live = {name: Live() for name in ("left", "right")}
        self.lost = {}
        self.motion = Motion(self, self, lambda *told: self.acts.append(told))

    def stop(self):
        self.acts.append("stop")

    def reset(self):
        self.acts.append("reset")

    def gone(self, unit):
        return self.lost.get(unit, NOTHING)


class Run:
    """An application that runs."""

    def __init__(self, acts, name):
        self.runner, self._acts, self._name = self, acts, name

    def abort(self, cause, now):
        self._acts.append((self._name, cause, now))


class Live:
    """A subsystem held by hand with a task that is wanted ON."""

    def __init__(self):
        self.desired = DesiredState()
        self.desired.turn_on("servo", "")


@pytest.fixture
def runtime():
    return Runtime()


def test_a_stop_holds_the_drives_before_anything_else_then_ends_every_run_and_is_told(runtime):  # law 27, R-X24
    assert not runtime.motion.is_stopped
    runtime.motion.stop("anna", WHY)
    assert runtime.acts == ["stop", ("a", WHY, 70), ("b", WHY, 70), (event.Stopped(True, WHY), "", "anna")]
    assert runtime.motion.is_stopped is True


def test_nothing_that_is_held_by_hand_comes_on_again_after_a_stop(runtime):  # law 27
    runtime.motion.stop("anna", WHY)
    assert [live.desired.is_on("servo") for live in runtime.live.values()] == [False, False]


def test_motion_is_allowed_again_without_anything_that_moves_by_itself(runtime):  # law 27
    runtime.motion.stop("anna", WHY)
    runtime.acts.clear()
    runtime.motion.allow("bert")
    assert runtime.acts == ["reset", (event.Stopped(False, NOTHING), "", "bert")]
    assert runtime.motion.is_stopped is False
    assert not any(live.desired.is_on("servo") for live in runtime.live.values())


def test_no_run_begins_while_everything_is_stopped(runtime):  # law 27, R-E01
    assert runtime.motion.refusal(["rt0"]) == NOTHING
    runtime.motion.stop("anna", WHY)
    assert runtime.motion.refusal(["rt0"]) == Reason.of("host.is_stopped")
    assert runtime.motion.refusal([]) == Reason.of("host.is_stopped")
    runtime.motion.allow("anna")
    assert runtime.motion.refusal(["rt0"]) == NOTHING


def test_no_run_begins_on_a_unit_that_is_gone(runtime):  # law 30, R-E01
    runtime.lost = {"rt1": Reason.plain("rt1 is gone"), "rt2": Reason.plain("rt2 is gone")}
    assert runtime.motion.refusal(["rt0", "rt3"]) == NOTHING
    assert runtime.motion.refusal([]) == NOTHING
    anew = Reason.of("host.start_anew", gone=Reason.plain("rt1 is gone"))
    assert runtime.motion.refusal(["rt0", "rt1", "rt2"]) == anew
