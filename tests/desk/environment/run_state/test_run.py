import pytest

from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.run import begun
from onika.desk.plan.preparation import prepare
from onika.model.application import with_numbers_as_lines
from onika.model.flow_path import numbered, spots
from onika.store.site import open_site
from onika.words.fault import Place
from onika.words.reason import Reason

SITE = open_site([], {}, None)
SYNTAX, _ = SITE.syntax()
NAMES = sorted({name for base in SITE.directories for name in base.applications})


def run_of(name):
    application, _ = SITE.application(name, SYNTAX)
    application, _ = numbered(application, 0)
    prepared = prepare(with_numbers_as_lines(application), Place(name), SITE, SYNTAX)
    return application, begun("a1", prepared.plan, 3, 5.0, StepMembership.of(application, SYNTAX))


@pytest.mark.parametrize("name", NAMES)
def test_every_action_belongs_to_a_step_and_every_step_with_actions_finds_them(name):  # R-E11, R-E13
    application, run = run_of(name)
    steps = spots(application)
    for number, flow in enumerate(run.plan.flows):
        for index in range(len(flow.actions)):
            step = run.step_at(flow.subsystem, index)
            assert step in steps, flow.actions[index]
            assert (number, index) in list(run.actions_of(step))


def test_what_is_shown_before_it_begins():
    _, run = run_of("two_arms")
    assert (run.view.number, run.view.began_at_s, run.view.state) == (3, 5.0, "beginning")
    assert run.homes == tuple(run.view.flows) and run.view.of == sum(len(flow.actions) for flow in run.plan.flows)


def test_what_is_not_in_the_plan_is_no_step():
    _, run = run_of("go_home")
    assert (run.step_at("elsewhere", 0), run.step_at("flow0", 7), run.action(4, 0)) == (0, 0, None)


def test_old_notes_are_forgotten():
    _, run = run_of("go_home")
    for number in range(100):
        run = run.noted(Reason.plain(str(number)))
    assert str(run.view.notes[-1]) == "99" and len(run.view.notes) == 60
