from dataclasses import replace

import pytest

from onika.desk.environment.icons.program_arms import arms_of, jobs_near
from onika.desk.environment.initial_model import opened
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.plan.preparation import prepare_run
from onika.model.application import Icon
from onika.model.redirect import Redirect
from onika.store.site import open_site

SITE = open_site([], {}, None)
MODEL, _ = opened(SITE, None, {})
JOINTS, POSE = frozenset({"Q_MEZ"}), frozenset({"X_MEZ"})


def plan_of(name, *redirects):
    return prepare_run(name, SITE, [Redirect.parse(text) for text in redirects]).plan


def jobs_of(plan):
    return list(dict.fromkeys(action.job for flow in plan.flows for action in flow.actions))


def test_the_arm_of_a_program_is_measured_by_its_driver_alone():  # R-D23
    plan = plan_of("go_home")
    (arm,) = arms_of(plan, jobs_of(plan), JOINTS, MODEL.libraries)
    assert ([task.name for task in arm.tasks], arm.devices) == (["puma"], {"boxes:arm_left"})
    assert (arm.arm, arm.made_for) == ("puma", "puma")
    assert {code.digest for code in arm.code} == {arm.driver.digest}


def test_a_pose_is_made_of_it_by_a_task_of_the_job_or_else_of_a_library():  # R-D23
    plan = plan_of("go_home")
    (arm,) = arms_of(plan, jobs_of(plan), POSE, MODEL.libraries)
    assert [task.name for task in arm.tasks] == ["puma", "fwdkin"]
    assert {code.digest for code in arm.code} == {task.digest for task in arm.tasks}


def test_of_two_arms_the_one_of_the_nearest_job_comes_first():  # R-D23
    plan = plan_of("two_arms")
    jobs = jobs_of(plan)
    names = [arm.arm for arm in arms_of(plan, jobs, JOINTS, MODEL.libraries)]
    assert sorted(names) == ["puma", "puma_right"]
    assert [arm.arm for arm in arms_of(plan, jobs[::-1], JOINTS, MODEL.libraries)] == names[::-1]


def test_who_stands_for_an_arm_is_measured_in_its_place():  # R-E09, R-D23
    plan = plan_of("go_home", "puma=scara")
    (arm,) = arms_of(plan, jobs_of(plan), JOINTS, MODEL.libraries)
    assert (arm.arm, arm.made_for) == ("scara", "puma")


@pytest.mark.parametrize("wanted", [frozenset(), frozenset({"NOBODYS"})])
def test_what_nothing_measures_has_no_arm(wanted):
    plan = plan_of("go_home")
    assert arms_of(plan, jobs_of(plan), wanted, MODEL.libraries) == ()


def test_jobs_are_looked_for_from_a_place_backwards_first():
    application = prepare_run("wave_three", SITE).application
    names = [step.onikon.name for step in application.flows[0].steps if isinstance(step, Icon)]
    assert list(jobs_near(application, "0", 0)) == list(dict.fromkeys(names))
    assert jobs_near(application, "7", 0) == jobs_near(application, "0", 0)


def test_a_task_of_a_library_that_means_something_else_by_what_it_reads_makes_no_pose_of_an_arm(monkeypatch):  # R-D23
    plan, tasks = plan_of("go_home"), MODEL.libraries.tasks
    # what it reads is called as the angles are, and is speeds
    of_a_pad = replace(tasks["deadband"], aliases=(("V_RAW", "Q_MEZ"), ("V_REF", "X_MEZ")))
    first = {"deadband": of_a_pad}
    monkeypatch.setattr(OpenLibraries, "tasks", property(lambda _: {**first, **tasks, **first}))
    (arm,) = arms_of(plan, jobs_of(plan), POSE, MODEL.libraries)
    assert [task.name for task in arm.others] == ["fwdkin"]
