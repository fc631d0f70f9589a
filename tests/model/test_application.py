from dataclasses import replace

import pytest

from onika.model.application import (
    Action,
    AppFlow,
    Application,
    Branch,
    Hole,
    Icon,
    actions,
    every_flow,
    is_target,
    wanted_targets,
    with_numbers_as_lines,
    without_breakpoints,
)
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax

SYNTAX = Syntax(
    tuple(
        IconType(name, 0, 0)
        for name in ("Complete job", "Complete application", "Joint job", "Joint object", "Pose object")
    ),
    (),
)


def icon(kind: str) -> Icon:
    return Icon(Onikon(kind.split(maxsplit=1)[0], kind, "", (), blank()))


JOB, TARGET, GRIP = icon("Joint job"), icon("Joint object"), icon("Complete job")


def test_a_job_and_its_target_are_one_action() -> None:
    flow = AppFlow((GRIP, JOB, TARGET, GRIP))
    assert actions(flow, SYNTAX) == ((0, GRIP, ()), (1, JOB, (TARGET,)), (3, GRIP, ()))


def test_a_job_without_a_target_behind_it_stands_alone() -> None:
    assert actions(AppFlow((JOB, GRIP, JOB, Hole(), TARGET, JOB)), SYNTAX) == (
        (0, JOB, ()),
        (1, GRIP, ()),
        (2, JOB, (Hole(),)),
        (5, JOB, ()),
    )


def test_a_complete_job_takes_no_target() -> None:
    assert actions(AppFlow((GRIP, TARGET)), SYNTAX) == ((0, GRIP, ()),)


def test_a_job_of_unknown_type_is_a_complete_action() -> None:
    strange = icon("Force job")  # R-D16
    assert actions(AppFlow((strange, TARGET)), SYNTAX) == ((0, strange, ()),)
    assert not is_target(icon("Force object"), SYNTAX)


def test_an_application_knows_its_holes() -> None:
    assert Application("a", False, (AppFlow((GRIP,)), AppFlow((JOB, Hole())))).has_hole
    assert not Application("a", False, (AppFlow((GRIP,)),)).has_hole


POSE = icon("Pose object")
TWO = Icon(Onikon("two", "Joint job", "", (), blank(), ("Pose object",)))
THREE = Icon(Onikon("three", "Joint job", "", (), blank(), ("Pose object", "Joint object")))
HOLE, OTHER = Hole(), Hole(kept="of unknown type")


@pytest.mark.parametrize(
    ("steps", "targets", "positions"),
    [
        ((TWO, TARGET, POSE, POSE), (TARGET, POSE), (1, 2)),
        ((TWO, TARGET, GRIP, POSE), (TARGET,), (1,)),
        ((TWO, HOLE, GRIP), (HOLE, HOLE), (1, 1)),
        ((TWO, HOLE), (HOLE, HOLE), (1, 1)),
        ((TWO, TARGET, HOLE, GRIP), (TARGET, HOLE), (1, 2)),
        ((TWO, HOLE, POSE), (HOLE, POSE), (1, 2)),
        ((TWO, HOLE, OTHER, POSE), (HOLE, OTHER), (1, 2)),
        ((THREE, HOLE, POSE, HOLE), (HOLE, POSE, HOLE), (1, 2, 3)),
        ((THREE, HOLE, TARGET), (HOLE, HOLE, TARGET), (1, 1, 2)),
        ((THREE, HOLE, Icon(Onikon("x", "pose OBJECT", "", (), blank())), HOLE), None, (1, 2, 3)),
        ((THREE,), (), ()),
    ],
)
def test_a_job_takes_its_targets_in_order_and_a_hole_stands_for_what_is_open(
    steps: tuple[Icon | Hole, ...], targets: tuple[Icon | Hole, ...] | None, positions: tuple[int, ...]
) -> None:
    action = actions(AppFlow((GRIP, *steps)), SYNTAX)[1]  # R-D13
    assert targets is None or action.targets == targets
    assert action.positions == tuple(at + 1 for at in positions)
    assert action.end == max((1, *action.positions)) + 1


def test_the_targets_an_action_wants_follow_from_its_type_and_its_further_ones() -> None:
    assert wanted_targets(THREE.onikon, SYNTAX) == ("Joint object", "Pose object", "Joint object")  # R-D13
    strange = Onikon("x", "Odd job", "", (), blank(), ("Pose object",))
    complete = Onikon("x", "Complete job", "", (), blank(), ("Pose object",))
    for onikon in (GRIP.onikon, TARGET.onikon, strange, complete):
        assert wanted_targets(onikon, SYNTAX) == ()


def test_every_flow_of_an_application_has_a_path() -> None:
    deep = Branch((AppFlow(()), AppFlow((GRIP, Branch((AppFlow((HOLE,)),))))))  # R-D13
    whole = Application("a", False, (AppFlow((GRIP,)), AppFlow((GRIP, deep))))
    assert [(path, len(flow.steps)) for path, flow in every_flow(whole)] == [
        ("flow 0", 1),
        ("flow 1", 2),
        ("flow 1, step 1, branch 0", 0),
        ("flow 1, step 1, branch 1", 2),
        ("flow 1, step 1, branch 1, step 1, branch 0", 1),
    ]
    assert whole.has_hole
    assert actions(whole.flows[1], SYNTAX) == (Action(0, GRIP),)


def test_steps_stand_at_the_lines_of_their_numbers_those_in_branches_too():
    inner = replace(icon("Joint job"), number=4, line=70)
    branch = Branch((AppFlow((inner, Hole(number=5))),), number=3, line=60)
    here = Application("play", False, (AppFlow((replace(icon("Complete job"), number=2, line=9), branch)),))
    job, moved = with_numbers_as_lines(here).flows[0].steps
    assert (job.line, moved.line, [step.line for step in moved.flows[0].steps]) == (2, 3, [4, 5])


def test_without_breakpoints_everything_else_is_as_it_was():  # R-D06
    marked = replace(icon("Joint job"), marker=True, marker_if="Q > 1", synch_tag="meet")
    here = Application("play", False, (AppFlow((Branch((AppFlow((marked,)),), line=4), marked)),))
    branch, job = without_breakpoints(here).flows[0].steps
    assert job == branch.flows[0].steps[0] == replace(icon("Joint job"), synch_tag="meet")
    assert branch.line == 4
