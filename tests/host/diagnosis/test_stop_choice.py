import pytest

from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.diagnosis.stop_choice import choices
from onika.wire.plan import PlannedAction, PlannedFlow
from onika.wire.steer import Position
from onika.words.reason import Reason


def flow(name, actions=2):
    steps = (PlannedAction(f"job{i} there", f"job{i}", "there", "a.appl", (), (), "", i + 1) for i in range(actions))
    return PlannedFlow(name, (), tuple(steps))


def stopped(name="flow0", action=0, failed=("puma",)):
    return Position(name, "stopped", action, failed=failed)


def waiting(name, *others):
    return Position(name, "waiting", 0, "meet", others)


ERROR = Cause(CauseKind.ERROR, Reason.plain("no"), "flow0", "puma")


def commands(options):
    return [command for command, _ in options]


def test_a_flow_that_stands_at_an_error_can_be_cleared_left_or_ended():  # R-E08, R-X06
    options = dict(choices(ERROR, [flow("flow0")], [stopped()]))
    assert list(options) == ["clear", "next", "skip N", "abort"]
    assert str(options["clear"]) == "clears puma and repeats job0 there with the same target"
    assert str(options["abort"]) == "ends the run: all tasks are killed, every drive holds"


def test_nothing_can_be_done_where_the_run_ends():  # R-X06
    ends = Cause(CauseKind.ERROR, Reason.plain("no"), "flow0", "puma", ends=True)
    assert choices(ends, [flow("flow0")], [stopped()]) == ()


@pytest.mark.parametrize("kind", [CauseKind.USER, CauseKind.LOST])
def test_nothing_can_be_done_after_a_stop_or_a_loss(kind):  # R-X06
    assert choices(Cause(kind, Reason.plain("gone")), [flow("flow0")], [stopped()]) == ()


def test_an_only_action_cannot_be_skipped_to():  # R-X06
    assert commands(choices(ERROR, [flow("flow0", 1)], [stopped()])) == ["clear", "next", "abort"]


def test_of_several_flows_each_is_named_and_whoever_waits_can_be_let_pass():  # R-E07, R-X06
    options = choices(ERROR, [flow("flow0"), flow("flow1")], [stopped(), waiting("flow1", "flow0")])
    assert commands(options) == ["clear flow0", "next flow0", "skip flow0 N", "pass flow1", "abort"]


def test_a_panic_button_must_be_let_go_first():  # R-K06, R-X06
    pressed = Cause(CauseKind.PRESSED, Reason.plain("panic button pressed"), "flow0", "puma")
    options = dict(choices(pressed, [flow("flow0")], [stopped()]))
    assert str(options["clear"]).startswith("once the panic button is let go: clears puma")


def test_what_was_refused_is_tried_again():  # R-X06
    refused = Cause(CauseKind.REFUSED, Reason.plain("on is refused"), "flow0", "puma")
    options = dict(choices(refused, [flow("flow0")], [stopped(failed=())]))
    assert str(options["clear"]) == "tries again and repeats job0 there with the same target"


def test_before_the_first_action_there_is_nothing_to_repeat():  # R-X06
    options = dict(choices(ERROR, [flow("flow0")], [stopped(action=-1)]))
    assert list(options) == ["clear", "abort"]
    assert str(options["clear"]) == "clears puma and goes on"


def test_a_deadlock_is_left_by_letting_one_pass():  # R-X03, R-X06
    positions = [waiting("flow0", "flow1"), waiting("flow1", "flow0"), waiting("flow2", "flow0")]
    options = choices(
        Cause(CauseKind.DEADLOCK, Reason.plain("circle"), "flow0"), [flow(f"flow{n}") for n in range(3)], positions
    )
    assert commands(options) == ["pass flow0", "pass flow1", "abort"]


def test_whoever_waits_for_one_that_stands_passes_or_the_other_is_cleared():  # R-X06
    deserted = Cause(CauseKind.DESERTED, Reason.plain("waits"), "flow1")
    flows = [flow("flow0"), flow("flow1")]
    options = choices(deserted, flows, [stopped(), waiting("flow1", "flow0")])
    assert commands(options) == ["clear flow0", "next flow0", "skip flow0 N", "pass flow1", "abort"]
    options = choices(deserted, flows, [Position("flow0", "done", 1), waiting("flow1", "flow0")])
    assert commands(options) == ["pass flow1", "abort"]
    assert str(dict(options)["pass flow1"]) == "lets it go on alone; safe only if it needs nothing of flow0"


def test_a_flow_that_waits_for_nested_flows_is_not_let_pass():  # R-X06
    joining = Position("flow0", "joining", 0, "", ("flow0.1",))
    options = choices(Cause(CauseKind.ERROR, Reason.plain("no"), "flow0.1", "puma"), [flow("flow0"), flow("flow0.1")], [
        joining, stopped("flow0.1")
    ])  # fmt: skip
    assert "pass flow0" not in commands(options)
