import pytest
from msgspec.structs import replace

from kit.labs.laboratory import Laboratory, job, target
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.settings import RunSettings
from onika.desk.trial.account import digest_of, give_account, timed_events
from onika.store.site import open_site
from onika.wire import event
from onika.words.reason import NOTHING

SITE = open_site([], {}, None)
BEGAN = event.Began(0, 0, 2, "jmoveC aside", 1.0)
PAUSED = event.Moved("flow0", "paused", 0, 2.0)
GOOD = event.Result(True, NOTHING, 4, 4, 9.0, 0.1, {"LAMP": 1}, (), "abc")


def test_what_happens_is_told_with_the_clock_standing(running):  # R-X07, law 15
    run, _ = running(BEGAN, GOOD)
    seen = [(type(message).__name__, run.stands or run.is_over) for message in timed_events(run, 60.0)]
    assert seen == [("Began", True), ("Result", True)]


def test_a_run_that_does_not_end_is_ended(running):  # R-X07
    run, _ = running(BEGAN)
    *_, last = timed_events(run, 5.0)
    assert str(last.cause) == "it has not come to its end after 5 s"


def test_the_digest_is_that_of_the_content_wherever_it_lies():  # R-X07
    plan = prepare_run("go_home", SITE).plan
    flow = plan.flows[0]
    moved = replace(flow, actions=tuple(replace(action, place="/elsewhere.appl", line=9) for action in flow.actions))
    assert digest_of(replace(plan, flows=(moved,))) == digest_of(plan)
    slower = replace(flow, actions=(replace(flow.actions[0], arguments="0 0 0 0 0 0 9"), *flow.actions[1:]))
    assert digest_of(replace(plan, flows=(slower,))) != digest_of(plan)
    assert digest_of(replace(plan, code=plan.code[1:])) != digest_of(plan)


@pytest.mark.site
def test_an_account_tells_what_was_done_and_how_long_it_took(tmp_path):  # R-X07
    lab = Laboratory(tmp_path)
    short = target("short", "Pause object", "0.3")
    path = lab.application("rest", [job("pauseC", "Pause job"), short, job("pauseC", "Pause job"), short])
    account = give_account(RunSettings(str(path), is_virtual=True), SITE)
    assert (account.refusals, account.cause) == ((), NOTHING)
    (part,) = account.parts
    assert [passed.name for passed in part.passed] == ["pauseC short", "pauseC short"]
    assert [round(passed.ended_s - passed.began_s, 1) for passed in part.passed] == [0.3, 0.3]
    assert len(account.hash) == 64


def test_what_is_refused_has_its_reasons(tmp_path):  # R-X07, R-B07
    account = give_account(RunSettings(str(tmp_path / "none.appl"), is_virtual=True), SITE)
    assert len(account.refusals) >= 1
    assert account.cause.key == "trial.is_refused"
