from dataclasses import replace

from onika.desk.environment.runs.puzzle_run import puzzle_of, uncounted
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.preparation import prepare_run
from onika.model.application import AppFlow, Application
from onika.model.redirect import Redirect
from onika.store.site import open_site
from onika.wire import act

SITE = open_site([], {}, None)
PLAN = prepare_run("two_arms", SITE).plan
OPENED = OpenApplication("a1", Application("mine", True, (AppFlow(()), AppFlow(()))), puzzle="both_hands")
FRESH = act.Run("a1", puts_back=True)


def test_an_application_is_judged_by_the_puzzle_that_it_was_begun_for():  # R-G10
    assert puzzle_of(OPENED, SITE).name == "both_hands"
    assert puzzle_of(replace(OPENED, puzzle=""), SITE) is None
    assert puzzle_of(replace(OPENED, puzzle="nothing_of_it"), SITE) is None


def test_a_run_counts_where_the_program_alone_begins_with_the_workcell_put_back():  # R-G10
    assert not uncounted(OPENED, PLAN, FRESH)
    assert uncounted(OPENED, PLAN, act.Run("a1")).key == "run.puzzle_not_put_back"
    redirected = replace(OPENED, redirects=(Redirect.parse("puma=puma_kin"),))
    assert uncounted(redirected, PLAN, FRESH).key == "run.puzzle_redirected"
    apart = replace(OPENED, stations={"flow1": "other"})
    assert uncounted(apart, PLAN, FRESH).key == "run.puzzle_apart"


def test_what_is_for_no_puzzle_always_counts():  # R-G10
    assert not uncounted(replace(OPENED, puzzle=""), PLAN, act.Run("a1"))
