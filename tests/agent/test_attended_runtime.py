import pytest

from kit.desk.site_runtimes import QuietRuntime, descriptors
from onika.agent import attended_runtime as room
from onika.agent.attended_runtime import AttendedRuntime
from onika.agent.use import FIRST_NS, LAST_NS
from onika.link.lost import LossCause
from onika.wire import live, request
from onika.words.reason import Reason

PATIENCE_S = 10.0


@pytest.fixture
def quiet(monkeypatch):
    monkeypatch.setattr(room, "LOOK_S", 0.01)
    return QuietRuntime()


@pytest.fixture
def attended(quiet):
    """Attends to it, with a clock that a test sets."""
    begun = []

    def attend(*, stays=False, clock=lambda: 0):
        runtime = AttendedRuntime(quiet.opened, stays=stays, clock=clock)
        begun.append(runtime)
        runtime.start()
        return runtime

    yield attend
    for runtime in begun:
        runtime.end(Reason.plain("the test is over"))
        runtime.join(PATIENCE_S)


def test_it_runs_until_it_is_ended_and_leaves_nothing(quiet, attended):  # R-A15
    before = descriptors()
    runtime = attended()
    quiet.come("ann#2")
    assert (runtime.ready(PATIENCE_S).state, runtime.news.port) == ("running", 4711)
    runtime.end(Reason.plain("enough"))
    runtime.join(PATIENCE_S)
    assert (runtime.news.state, str(runtime.news.reason)) == ("over", "enough")
    assert not quiet.is_open and descriptors() == before


def test_why_it_does_not_start_is_told(quiet, attended):  # R-A15
    quiet.fail(LossCause.CLOSED, Reason.plain("the port is taken"))
    news = attended().ready(PATIENCE_S)
    assert (news.state, str(news.reason), news.lives) == ("failed", "the port is taken", False)


def test_a_runtime_that_refuses_to_be_looked_at_has_failed(quiet, attended):
    quiet.answers[live.Survey] = request.Refused(Reason.plain("not now"))
    news = attended().ready(PATIENCE_S)
    assert (news.state, str(news.reason)) == ("failed", "not now")


def test_where_nobody_comes_it_ends_by_itself_unless_it_stays(quiet, attended):  # R-A15
    staying = attended(stays=True, clock=iter(range(0, FIRST_NS * 1000, FIRST_NS)).__next__)
    runtime = attended(clock=iter(range(0, FIRST_NS * 1000, FIRST_NS)).__next__)
    runtime.join(PATIENCE_S)
    assert runtime.news.state == "over" and "nobody was connected" in str(runtime.news.reason)
    assert staying.ready(PATIENCE_S).lives


def test_it_goes_on_while_somebody_is_there_or_an_application_runs(quiet, attended):  # R-A15
    times = iter(range(0, FIRST_NS * 4, FIRST_NS))
    quiet.hold("flow0", "", "assemble")
    runtime = attended(clock=lambda: next(times, FIRST_NS * 4))
    assert runtime.ready(PATIENCE_S).lives
    quiet.come("ann#2")
    runtime.join(0.2)
    assert runtime.news.lives and [session.name for session in runtime.news.sessions] in ([], ["ann#2"])


def test_it_waits_for_whoever_was_told_of_it_as_after_the_last_one(quiet, attended):  # R-A15
    now = [0]
    quiet.come("ann#2")
    runtime = attended(clock=lambda: now[0])
    quiet.looked_at()
    quiet.come()
    quiet.looked_at()
    now[0] = LAST_NS - 1
    assert runtime.expect_guest()
    now[0] = 2 * LAST_NS - 2
    quiet.looked_at()
    assert runtime.news.lives
    now[0] = 2 * LAST_NS - 1
    runtime.join(PATIENCE_S)
    assert runtime.news.state == "over" and not runtime.expect_guest()


def test_nobody_is_told_of_one_that_is_about_to_end(quiet, attended):  # R-A15
    runtime = attended()
    assert runtime.ready(PATIENCE_S).lives and runtime.expect_guest()
    runtime.end(Reason.plain("enough"))
    assert not runtime.expect_guest()
