"""Every answer equals the simulation: what is foreseen of every fault is what then happens, and in that time."""

import pytest

from kit.faults.fault_planting import FaultyRuntime
from kit.faults.foreseen_changes import foretold, gathered
from onika.host.foresight.questions import FAULTS
from onika.wire import event, request
from onika.words.reason import Reason

BEGINNINGS = {
    "abort": {},
    "wait": {"on_error": "wait"},
    "finish": {"on_error": "wait", "on_loss": "finish"},
    "run": {"on_loss": "run"},
}
MANY = [
    beginning if beginning == "abort" else pytest.param(beginning, marks=pytest.mark.slow) for beginning in BEGINNINGS
]
ONLY_IN_PROCESSES = {"runtime-killed", "runtime-frozen", "partner"}
"""In virtual time there is no process beside the runtime's, and its clock stands while a partner is awaited."""


def questions():
    """All that can be asked of the runtime, as it is begun in each way."""
    runtime = FaultyRuntime().start()
    return [one for one in runtime.questions() if one[0] not in ONLY_IN_PROCESSES]


QUESTIONS = questions()


def happened(runtime):
    return gathered(runtime.changes())


def assert_equal(foresight, runtime):
    foretold_changes, real_changes = foretold(foresight), happened(runtime)
    states = {about: [state for state, _ in steps] for about, steps in foretold_changes.items()}
    assert {about: [state for state, _ in steps] for about, steps in real_changes.items()} == states
    for about, steps in real_changes.items():
        for (state, at_ms), (_, within_ms) in zip(steps, foretold_changes[about], strict=True):
            assert at_ms <= within_ms, f"{about} is {state} after {at_ms} ms, not within {within_ms} ms"


@pytest.mark.parametrize("beginning", MANY)
@pytest.mark.parametrize(("fault", "subject"), QUESTIONS)
def test_what_is_foreseen_is_what_then_happens(fault, subject, beginning):  # R-X24
    runtime = FaultyRuntime(**BEGINNINGS[beginning]).start()
    (foresight,) = runtime.foresee(fault, subject)
    runtime.plant(fault, subject)
    assert_equal(foresight, runtime)


@pytest.mark.parametrize(
    ("fault", "subject", "beginning"),
    [
        ("task", "flow0/push", "wait"),
        ("task", "flow0/lamp", "wait"),
        ("drive", "yard:m0", "wait"),
        ("nan", "flow0/FORCE", "wait"),
        ("unit-frozen", "rt0", "wait"),
        ("link", "me", "finish"),
        ("link", "me", "run"),
    ],
)
def test_it_is_so_too_where_a_run_stands_still_pauses_or_goes_on(fault, subject, beginning):  # R-X24, R-E08, R-X12
    test_what_is_foreseen_is_what_then_happens(fault, subject, beginning)


def test_a_full_disk_cuts_the_recording_and_nothing_else(tmp_path):  # R-X24, R-X05
    runtime = FaultyRuntime(record=str(tmp_path / "run.mcap")).start(by_hand=False)
    (foresight,) = runtime.foresee("disk")
    assert [(effect.kind, effect.after) for effect in foresight.effects] == [("recording", "CUT")]
    runtime.plant("disk", "")
    assert happened(runtime) == {}
    told_ms = [
        (at_ns - runtime.began_ns) * 1e-6
        for at_ns, message in runtime.server.times
        if isinstance(message, event.Warned) and message.text.key == "host.recording_not_whole"
    ]
    assert len(told_ms) == 1
    assert told_ms[0] <= foresight.effects[0].within_ms
    runtime.ask(request.Abort(Reason.plain("enough")))
    runtime.let_pass(50.0)


def test_to_ask_changes_nothing():  # R-X24
    runtime, other = FaultyRuntime().start(), FaultyRuntime().start()
    for fault, subject in runtime.questions():
        runtime.foresee(fault, subject)
    runtime.let_pass(50.0)
    other.let_pass(50.0)
    assert runtime.driver.digest == other.driver.digest
    assert runtime.changes() == other.changes()


def test_every_fault_is_tried():  # R-X24
    tried = {fault for fault, _ in QUESTIONS} | ONLY_IN_PROCESSES | {"disk"}
    assert tried == {fault.name for fault in FAULTS}
