from onika.model.application import AppFlow, Application, Hole, Icon, actions, is_target
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax

SYNTAX = Syntax(
    tuple(IconType(name, 0, 0) for name in ("Complete job", "Complete application", "Joint job", "Joint object")), ()
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
