import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import action
from kit.worlds.rail_world import rail_tasks
from onika.host.loading.plan_form import shown, wrong_code, wrong_plan, wrong_tasks
from onika.wire.plan import Choose, Do, Fork, Halt, Join, Jump, Rest
from onika.wire.request import TargetValues

PLAN = rail_tasks().plan([action("mass", "servo", arguments="1.0")])
(FLOW,) = PLAN.flows
(STEP,) = FLOW.actions
MASS = FLOW.tasks[0]
DIGESTS = {code.digest for code in PLAN.code}


def keys(faults):
    return [fault.reason.key for fault in faults]


def with_flow(**changes):
    return replace(PLAN, flows=(replace(FLOW, **changes),))


def with_step(**changes):
    return with_flow(actions=(replace(STEP, **changes),))


def test_an_honest_plan_has_the_form_of_one():
    assert wrong_plan(PLAN, (TargetValues(0, 0, "joint object", (1.0,)),)) == []


@pytest.mark.parametrize(
    ("plan", "key"),
    [
        (replace(PLAN, application=""), "host.plan_unnamed"),
        (replace(PLAN, flows=()), "host.plan_empty"),
        (replace(PLAN, flows=(FLOW, FLOW)), "host.subsystem_twice"),
        (replace(PLAN, application="a\0b"), "host.text_form"),
        (with_flow(subsystem="x" * 5000), "host.name_form"),
        (with_flow(subsystem="a/b"), "host.name_form"),
        (with_flow(parent=3), "host.number_outside"),
        (with_flow(tasks=(MASS, *FLOW.tasks)), "host.flow_task_twice"),
        (with_step(tasks=("mass", "ghost")), "host.action_tasks"),
        (with_step(tasks=("mass", "mass")), "host.action_task_twice"),
        (with_step(rates=(("mass", float("nan")),)), "host.rate_infinite"),
        (with_step(place="p" * 5000), "host.text_form"),
        (with_flow(program=(Do(0), Rest(7), Halt())), "host.number_outside"),
        (with_flow(program=(Do(0), Fork(((5, 0),)), Join((0,)), Halt())), "host.number_outside"),
        (with_flow(program=(Do(0), Fork(()), Join((9,)), Halt())), "host.number_outside"),
    ],
)  # R-F01
def test_what_no_environment_sends_is_refused_with_its_reason(plan, key):
    assert keys(wrong_plan(plan, ())) == [key]


@pytest.mark.parametrize(
    "program",
    [
        (Do(0),),
        (Do(0), Jump(9), Halt()),
        (Do(3), Halt()),
        (Do(0), Choose(()), Halt()),
        (Do(0), Join((0,)), Halt()),
        (Do(0), Fork(()), Halt()),
        (Halt(),),
    ],
)  # R-F01
def test_a_program_that_leads_nowhere_is_refused(program):
    assert len(wrong_plan(with_flow(program=program), ())) == 1


@pytest.mark.parametrize(
    "target", [TargetValues(4, 0, "x", ()), TargetValues(0, 4, "x", ()), TargetValues(0, -1, "x", ())]
)
def test_a_target_of_no_action_is_refused(target):  # R-F01
    assert keys(wrong_plan(PLAN, (target,))) == ["host.number_outside"]


@pytest.mark.parametrize(
    ("task", "key"),
    [
        (replace(MASS, type="sometimes"), "host.task_type"),
        (replace(MASS, name=""), "host.name_form"),
        (replace(MASS, rtpu="a\0"), "host.name_form"),
        (replace(MASS, digest="another"), "host.code_missing"),
        (replace(MASS, frequency=float("inf")), "host.rate_infinite"),
        (replace(MASS, invar=("force",)), "host.variable_name"),
        (replace(MASS, local=(("K", ("w" * 5000,)),)), "host.text_form"),
    ],
)  # R-F01
def test_a_task_that_no_file_describes_is_refused(task, key):
    assert keys(wrong_tasks((task,), DIGESTS)) == [key]


def test_code_is_named_by_its_content():  # R-F01, law 24
    (code, *_) = PLAN.code
    assert wrong_code((code,)) == []
    assert keys(wrong_code((replace(code, source=code.source + "\n"),))) == ["host.digest_wrong"]
    assert keys(wrong_code((replace(code, module="a b"),))) == ["host.name_form"]


def test_a_text_of_somebody_else_is_shown_short_and_without_control_characters():  # R-B07
    assert shown("\x1b[31mred") == "?[31mred"
    assert len(shown("x" * 10_000)) == 81
