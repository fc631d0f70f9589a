from dataclasses import replace

import pytest
from tests.model.rules.upper import (
    HOLE,
    MOVE,
    POSE,
    REACH,
    SYNTAX,
    THERE,
    VIA,
    application,
    branch,
    conf,
    flow,
    icon,
    job,
    part,
)

from onika.model.application import AppFlow
from onika.model.rules.iconify import ActionType, application_type, job_type
from onika.model.syntax import IconType, Syntax
from onika.model.task import Task
from onika.words.fault import Refusal

TASKS = {
    "servo": Task("servo", "servo"),
    "jmove": Task("jmove", "jmove", object_type="joint JOB"),
    "cmove": Task("cmove", "cmove", object_type="Cartesian job"),
    "via": Task("via", "via", object_type="Joint job", more_targets=("cartesian object",)),
    "odd": Task("odd", "odd", object_type="Odd job"),
    "lost": Task("lost", "lost", object_type="Joint job", more_targets=("Odd object",)),
}


@pytest.mark.parametrize(
    ("tasks", "kind"),
    [
        (("servo",), ActionType("Complete job")),
        (("servo", "jmove"), ActionType("Joint job")),
        (("cmove", "jmove"), ActionType("Cartesian job")),
        (("via",), ActionType("Joint job", ("Cartesian object",))),
        (("odd",), ActionType("Odd job")),
    ],
)
def test_a_job_has_the_type_of_its_first_trigger_with_a_target(tasks: tuple[str, ...], kind: ActionType) -> None:
    assert job_type(conf("x", *tasks), TASKS, SYNTAX) == kind  # reading 16, R-C29, R-D13


def reasons(result: ActionType | tuple[Refusal, ...]) -> list[str]:
    assert not isinstance(result, ActionType)
    return [str(refusal.reason) for refusal in result]


def test_a_configuration_that_is_not_whole_is_refused() -> None:
    assert reasons(job_type(conf("x"), TASKS, SYNTAX)) == ["`x` has no tasks"]
    assert reasons(job_type(conf("x", "a", "jmove", "b"), TASKS, SYNTAX)) == [
        "the task a of `x` is missing",
        "the task b of `x` is missing",
    ]
    assert reasons(job_type(conf("x", "lost"), TASKS, SYNTAX)) == [
        "`lost` takes a target of the type Odd object, which the syntax does not define"
    ]


@pytest.mark.parametrize(
    ("flows", "kind"),
    [
        ([flow(MOVE, THERE, job())], ActionType("Complete application")),
        ([flow(MOVE, HOLE, job(), MOVE, HOLE)], ActionType("Joint application")),
        ([flow(part("inner", "Cartesian"), HOLE)], ActionType("Cartesian application")),
        ([flow(MOVE, HOLE, REACH, HOLE)], ActionType("Joint application", ("Cartesian object",))),
        ([flow(VIA, HOLE)], ActionType("Joint application", ("Cartesian object",))),
        ([flow(VIA, THERE, HOLE)], ActionType("Cartesian application")),
        ([flow(job()), flow(job(), branch(flow(MOVE, HOLE), flow()))], ActionType("Joint application")),
    ],
)
def test_an_application_has_the_type_of_its_holes(flows: list[AppFlow], kind: ActionType) -> None:
    for is_parallel in (False, True):  # R-D09, readings 31 and 32, R-D13
        assert application_type(application(*flows, is_parallel=is_parallel), SYNTAX) == kind


def test_a_hole_for_an_action_is_refused() -> None:
    result = application_type(application(flow(job(), HOLE, MOVE, HOLE)), SYNTAX)  # R-D09
    assert reasons(result) == ["a hole, step 1 of flow 0, is no place for a target"]


def test_an_application_that_is_not_whole_is_refused_with_every_reason() -> None:
    result = application_type(application(flow(MOVE, POSE), flow()), SYNTAX)
    assert [str(reason).split(",")[0] for reason in reasons(result)] == [
        "expected edges that fit",
        "expected an action in flow 1",
    ]


def test_where_the_syntax_has_no_type_for_it_that_is_said() -> None:
    poorer = Syntax(tuple(kind for kind in SYNTAX.types if kind.name != "Joint application"), ())
    assert reasons(application_type(application(flow(MOVE, HOLE)), poorer)) == [
        "its holes want a Joint object, and the syntax has no Joint application, only Cartesian application"
    ]
    without = Syntax(tuple(kind for kind in SYNTAX.types if kind.name != "Cartesian object"), ())
    assert reasons(application_type(application(flow(VIA, HOLE)), without)) == [
        "its holes want a Cartesian object, which the syntax does not define"
    ]


def test_the_only_target_whose_edge_fits_is_wanted_where_no_name_does() -> None:
    kinds = (*SYNTAX.types, IconType("Fast job", 1, 3), IconType("Fast application", 1, 3))  # reading 32
    assert application_type(application(flow(icon("f", "Fast job"), HOLE)), replace(SYNTAX, types=kinds)) == ActionType(
        "Cartesian application"
    )
