from kit.record.recording_builder import run
from onika.desk.environment.run_state import flow_progress
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.replay import RunHistory
from onika.desk.environment.run_state.run import begun
from onika.wire import event
from onika.words.reason import Reason

PLAN = run().prepare.plan
NAMES = [action.name for action in PLAN.flows[0].actions]


def turns(count):
    """Both actions, one after the other, many times."""
    for k in range(count):
        yield round(k * 1e9), "flow0", event.Began(0, k % 2, 2, NAMES[k % 2], float(k))
        yield round((k + 0.5) * 1e9), "flow0", event.Done(0, k % 2, k + 0.5)


def test_any_instant_is_what_was_told_up_to_it():  # R-X05
    first, events = begun("a1", PLAN, 0, 0.0, StepMembership({}, {})), list(turns(200))
    replay = RunHistory(first, events)
    for at_s in (0.0, 0.49, 0.5, 31.9, 32.0, 63.7, 99.25, 199.0, 199.5, 1e6):
        expected = first
        for at, _, message in events:
            expected = flow_progress.after(expected, message) if at <= at_s * 1e9 else expected
        assert replay.at(at_s) == expected.view


def test_nothing_can_be_chosen_at_a_standstill_of_the_past():  # R-X05
    stop = event.Explained(
        "flow0",
        "servo",
        "",
        0,
        "",
        Reason.plain("it failed"),
        "",
        0,
        (),
        (),
        (("retry", Reason.plain("again")),),
        1.0,
        "error",
    )
    replay = RunHistory(begun("a1", PLAN, 0, 0.0, StepMembership({}, {})), [(1_000_000_000, "flow0", stop)])
    assert replay.at(0.5).stops == {}
    assert (str(replay.at(1.0).stops["flow0"].text), replay.at(1.0).stops["flow0"].choices) == ("it failed", ())
