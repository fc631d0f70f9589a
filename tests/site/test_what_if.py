"""What if? is asked of real processes; then the very thing is done to them, and what comes is what was foreseen.

What is compared are effects and events by what they are about, never sentences. A runtime that outlives a fault is used
again.
"""

from functools import wraps

import pytest

from kit.faults.foreseen_changes import foretold
from kit.faults.struck_runtime import MachineWasLateError, StruckRuntime

pytestmark = pytest.mark.site

SPARE_MS = 3000.0
"""A machine that has other things to do tells everything later by so much at most."""

TRIES = 5


@pytest.fixture(scope="module")
def started(tmp_path_factory):
    """The runtimes started so far; the last one is used as long as it is whole."""
    runtimes = []
    yield runtimes
    for runtime in runtimes:
        runtime.close()


@pytest.fixture
def there(started, tmp_path_factory):
    if not started or started[-1].is_spent:
        started.append(StruckRuntime(tmp_path_factory.mktemp("there")))
    yield started[-1]
    if not started[-1].is_spent:
        started[-1].settle()


def undisturbed(test):
    """Tries again where the machine was late by itself, as long as the runtime is whole."""

    @wraps(test)
    def tried(there, **more):
        for _ in range(TRIES):
            try:
                return test(there, **more)
            except MachineWasLateError:
                if there.is_spent:
                    raise
                there.settle()
        pytest.fail("the machine was late each time")

    return tried


def settled(states, foreseen):
    """Without what a busy machine adds: a drive that hears nothing for a moment holds, and goes on or is fenced."""
    kept = []
    for state in states:
        if state == "DRIVEN" and kept[-1:] == ["HELD"]:
            kept.pop()
        else:
            kept.append(state)
    return kept[1:] if foreseen == ["TRIPPED"] and kept[:1] == ["HELD"] else kept


def assert_equal(foresight, real, failures=()):
    """The states in their order, and in time."""
    foreseen = {about: [state for state, _ in steps] for about, steps in foretold(foresight).items()}
    states = {about: settled([state for state, _ in steps], foreseen.get(about)) for about, steps in real.items()}
    assert {about: steps for about, steps in states.items() if steps} == foreseen, failures
    for about, steps in foretold(foresight).items():
        (_, at_ms), (_, within_ms) = real[about][-1], steps[-1]
        assert at_ms <= within_ms + SPARE_MS, about


def assert_foreseen(there, fault, subject=""):
    foresight = there.foresee(fault, subject)
    assert foretold(foresight)
    assert_equal(foresight, there.strike(fault, subject), there.failures)
    return foresight


@pytest.mark.parametrize("task", ["flow0/push", pytest.param("flow0/lamp", marks=pytest.mark.slow), "hand/arm2"])
@undisturbed
def test_a_task_that_fails(there, task):  # R-X24, R-E08
    there.begin()
    there.hold()
    assert_foreseen(there, "task", task)


@pytest.mark.parametrize("device", [pytest.param("arm_left_kin", marks=pytest.mark.slow), "arm_right_kin"])
@undisturbed
def test_a_button_that_is_pressed(there, device):  # R-X24
    there.begin()
    there.hold()
    assert_foreseen(there, "button", f"boxes:{device}")


@pytest.mark.parametrize("on_loss", ["stop", "finish", pytest.param("run", marks=pytest.mark.slow)])
@undisturbed
def test_a_beginner_who_is_silent(there, on_loss):  # R-X24, R-X12
    there.begin(on_loss=on_loss)
    foresight = there.foresee("holder", "beginner")
    assert_equal(foresight, there.strike("holder", "beginner"), there.failures)
    states = [effect.after for effect in foresight.effects if effect.kind == "flow"]
    assert ("pausing" in states) == (on_loss == "finish") == there.is_pausing()


@undisturbed
def test_a_holder_who_is_silent(there):  # R-X24, R-X12
    there.begin()
    there.hold()
    assert_foreseen(there, "holder", "holder")


@undisturbed
def test_a_stop_of_everything(there):  # R-X24, law 27
    there.begin()
    there.hold()
    assert_foreseen(there, "stop")


@pytest.mark.slow
@pytest.mark.parametrize(("fault", "subject"), [("unit-frozen", "rt0"), ("devices-frozen", "")])
@undisturbed
def test_a_process_that_is_frozen(there, fault, subject):  # R-X24, law 17
    there.begin()
    there.hold()
    assert_foreseen(there, fault, subject)


@pytest.mark.parametrize("unit", ["rt0", pytest.param("rt1", marks=pytest.mark.slow)])
@undisturbed
def test_a_unit_that_is_killed(there, unit):  # R-X24, law 17
    there.begin()
    there.hold()
    assert_foreseen(there, "unit-killed", unit)


@undisturbed
def test_the_device_server_that_is_killed(there):  # R-X24, law 17
    there.begin()
    there.hold()
    assert_foreseen(there, "devices-killed")


@undisturbed
def test_the_runtime_that_is_killed(there):  # R-X24, R-E10
    there.begin()
    there.hold()
    foresight = there.foresee("runtime-killed")
    assert {effect.after for effect in foresight.effects} == {"GONE", "KILLED", "gone"}
    assert not any(effect.told for effect in foresight.effects)
    assert there.strike("runtime-killed") == {}
    gone_ms = max(effect.within_ms for effect in foresight.effects)
    assert there.traces.left_over((gone_ms + SPARE_MS) / 1000.0) == []
