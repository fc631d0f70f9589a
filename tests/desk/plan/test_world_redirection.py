import pytest

from onika.desk.plan.flow_worlds import worlds_by_flow
from onika.desk.plan.preparation import prepare_run
from onika.desk.plan.redirection import homes_of, seats
from onika.desk.plan.world_redirection import RedirectableWorld, world_seats
from onika.model.redirect import Redirect
from onika.store.library import open_libraries
from onika.store.site import open_site

SITE = open_site([], {}, None)


def wishes(*texts):
    return tuple(map(Redirect.parse, texts))


def prepared(name, *redirects):
    return prepare_run(name, SITE, wishes(*redirects))


def devices(run, flow):
    local = [dict(task.local) for task in run.plan.flows[flow].tasks]
    return {lines["DEVICE"][0] for lines in local if "DEVICE" in lines}


def test_a_flow_drives_another_world_with_the_same_tasks_and_its_file_is_as_it_was():  # R-E09
    path = SITE.application_file("two_arms")
    before = path.read_bytes()
    run, plain = prepared("two_arms", "1:boxes:=boxes@copy:"), prepared("two_arms")
    assert run.faults == ()
    assert [[task.name for task in flow.tasks] for flow in run.plan.flows] == [
        [task.name for task in flow.tasks] for flow in plain.plan.flows
    ]
    assert devices(run, 0) == devices(plain, 0)
    assert devices(run, 1) == {device.replace("boxes:", "boxes@copy:") for device in devices(plain, 1)}
    assert [flow.worlds for flow in run.plan.flows] == [(("boxes", "boxes"),), (("boxes", "boxes@copy"),)]
    assert worlds_by_flow(run.plan) == {"flow0": ("boxes",), "flow1": ("boxes@copy",)}
    assert path.read_bytes() == before


def test_the_choice_of_a_flow_holds_for_what_is_nested_in_it():  # R-E09
    run = prepared("wave_together", "0:boxes:=cell:")
    assert len(run.plan.flows) > 1
    assert worlds_by_flow(run.plan) == {"flow0": ("cell",)}


def test_the_task_that_stands_for_another_is_in_the_other_world_too():  # R-E09
    run = prepared("two_arms", "0:puma=puma_kin", "0:boxes:=cell:")
    assert run.faults == ()
    assert "cell:arm_left_kin" in devices(run, 0)


@pytest.mark.parametrize(
    ("redirect", "expected"),
    [
        ("sea:=cell:", "redirect sea:=cell:: expected a world of two_arms (boxes:), found sea:"),
        ("1:sea:=cell:", "redirect 1:sea:=cell:: expected a world of flow 1 (boxes:), found sea:"),
        ("7:boxes:=cell:", "expected a flow by its number or its subsystem (flow0, flow1), found 7"),
    ],
)
def test_a_wish_for_a_world_that_the_flow_does_not_drive_is_told(redirect, expected):  # R-E09
    assert any(expected in f"{fault.place}: {fault.reason}" for fault in prepared("two_arms", redirect).faults)


def test_two_worlds_in_one_place_are_told():  # R-E09
    faults = prepared("two_arms", "boxes:=cell:", "boxes:=sea:").faults
    assert [str(fault.reason) for fault in faults] == ["expected one task in place of boxes:, found boxes:=cell: too"]


def test_the_worlds_of_each_flow_are_told_with_who_stands_there():  # R-E09
    run, (wish,) = prepared("two_arms", "1:boxes:=cell:"), wishes("1:boxes:=cell:")
    assert world_seats(run.plan, (wish,)) == {
        "flow0": (RedirectableWorld("boxes", "boxes"),),
        "flow1": (RedirectableWorld("boxes", "cell"),),
    }
    assert homes_of(wish, run.plan, run.program) == ("flow0", "flow1")


def test_in_another_world_the_device_of_the_other_flow_is_free():  # R-E09, R-X01
    library = [record.task for each in open_libraries(SITE.directories) for record in each.tasks.values()]

    def refusals(*redirects):
        run = prepared("two_arms", *redirects)
        seat = {seat.task.name: seat for seat in seats(run.program, run.plan, wishes(*redirects), library)["flow0"]}
        candidate = next(each for each in seat["puma"].candidates if each.task.name == "puma_right")
        return [str(refusal.reason) for refusal in candidate.refusals]

    assert refusals() == ["its device boxes:arm_right is claimed by `puma_right`"]
    assert refusals("1:boxes:=boxes@copy:") == []
