import pytest

from onika.desk.plan.preparation import prepare_run
from onika.desk.plan.redirection import seats
from onika.model.redirect import Redirect
from onika.store.library import open_libraries
from onika.store.site import open_site

SITE = open_site([], {}, None)


def prepared(name, *redirects):
    return prepare_run(name, SITE, tuple(map(Redirect.parse, redirects)))


def faults_of(name, *redirects):
    return [f"{fault.place}: {fault.reason}" for fault in prepared(name, *redirects).faults]


@pytest.mark.parametrize(
    ("redirects", "expected"),
    [
        (
            ("puma=scara", "puma=puma_kin"),
            ("redirect puma=puma_kin: expected one task in place of puma, found puma=scara too"),
        ),
        (("7:puma=scara",), ("redirect 7:puma=scara: expected a flow by its number or its subsystem (flow0), found 7")),
        (("puma=nobody",), "redirect puma=nobody: expected a task on the search path, found no nobody"),
        (
            ("scara=puma",),
            ("expected a task of go_home (diff, gravcomp, jtraj, led_monitor, pd, puma, torque_sum), found scara"),
        ),
        (("0:scara=puma",), "a task of flow 0 (diff"),
        (("puma=gripper",), "`gripper` does not write BASE, HOME, KD"),
    ],
)
def test_a_wish_that_cannot_be_is_told_with_what_could(redirects, expected):  # R-E09
    assert any(expected in fault for fault in faults_of("go_home", *redirects))


def test_a_redirected_plan_names_who_stands_for_whom_and_its_file_is_as_it_was():  # R-E09
    path = SITE.application_file("go_home")
    before = path.read_bytes()
    run = prepared("go_home", "puma=puma_kin")
    (flow,) = run.plan.flows
    assert run.faults == ()
    assert "puma_kin" in {task.name for task in flow.tasks}
    assert "puma" not in {task.name for task in flow.tasks}
    assert [(name, old.name) for name, old in flow.replaced] == [("puma_kin", "puma")]
    assert {"arm", "arm_kin"} <= {code.module for code in run.plan.code}
    assert path.read_bytes() == before


def test_each_flow_has_a_choice_of_its_own():  # R-E09
    run = prepared("two_arms", "0:puma=puma_kin", "flow1:puma_right=puma_right_kin")
    names = [{task.name for task in flow.tasks} for flow in run.plan.flows]
    assert run.faults == ()
    assert ["puma_kin" in names[0], "puma_right_kin" in names[1], "puma_kin" in names[1]] == [True, True, False]


def test_the_choice_of_a_flow_holds_for_what_is_nested_in_it():  # R-E09
    run = prepared("wave_together", "0:puma_right=puma_right_kin", "0:puma=puma_kin")
    living = {task.name for flow in run.plan.flows for task in flow.tasks}
    assert run.faults == ()
    assert {"puma_kin", "puma_right_kin"} <= living
    assert not {"puma", "puma_right"} & living


def test_every_task_of_a_flow_is_offered_those_that_can_stand_for_it_and_told_why_others_cannot():  # R-E09
    run = prepared("two_arms", "0:puma=scara")
    known_tasks = [record.task for library in open_libraries(SITE.directories) for record in library.tasks.values()]
    seats_of = seats(run.program, run.plan, (Redirect("puma", "scara", "0"),), known_tasks)
    assert list(seats_of) == ["flow0", "flow1"]
    seat = {seat.task.name: seat for seat in seats_of["flow0"]}["puma"]
    can = [each.task.name for each in seat.candidates if not each.refusals]
    cannot = {each.task.name: str(each.refusals[0].reason) for each in seat.candidates if each.refusals}
    assert seat.taken_by == "scara"
    assert {"puma_kin", "scara", "scara_kin"} <= set(can)
    assert cannot["puma_right"] == "its device boxes:arm_right is claimed by `puma_right`"
    other = {seat.task.name: seat for seat in seats_of["flow1"]}["puma_right"]
    assert other.taken_by == "puma_right"
    assert "its device boxes:scara_left is claimed by `scara`" in {
        str(refusal.reason) for each in other.candidates for refusal in each.refusals
    }
