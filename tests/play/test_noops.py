"""Stories of no-ops, which take no time (§4.3.2, R-D11)."""

from kit.engine.play import Play
from kit.engine.play_lines import JOB, NOOP, begins, ends, goes_on, opened, passes, started
from kit.plans import build
from onika.engine.news import Run, Settled, Spawned
from onika.engine.orders import Done, End, Moved, Settle, Together
from onika.wire.steer import Pause, Resume
from onika.words.reason import Reason


def test_no_ops_are_told_and_take_no_time():  # R-D11
    assert (
        started([NOOP, JOB, NOOP, NOOP, JOB, NOOP], first=passes(0, 0) + begins(0, 1))
        >> ends(0) << Done(0, 1) << passes(0, 2) << passes(0, 3) << begins(0, 4)
        >> ends(0) << Done(0, 4) << passes(0, 5) << Moved(0, "done", 5) << Settle()
    )  # fmt: skip


def test_an_application_of_no_ops_is_done_at_once():  # R-D11
    engine = build.engine([NOOP, NOOP])
    orders = [*passes(0, 0), *passes(0, 1), Moved(0, "done", 1), Settle()]
    assert Play(engine) >> Run() << orders >> Settled() << End(True)


def test_a_no_op_with_a_tag_waits_as_any_other_action():  # R-D11, R-E04
    flows = [build.noop("meet"), JOB], [JOB, build.job("move", trigger="move", synch_tag="meet")]
    assert (
        opened(*flows)
        >> Spawned(1, "move") << Moved(0, "waiting", -1, "meet", (1,)) << begins(1, 0)
        >> ends(1) << Done(1, 0) << passes(0, 0) << Together("meet", (0, 1)) << goes_on(0, 1) << begins(1, 1)
    )  # fmt: skip


def test_a_breakpoint_after_a_no_op_pauses_behind_it():  # R-D11, reading 25
    assert (
        started([JOB, build.noop(marker=True), NOOP, JOB])
        >> ends(0) << Done(0, 0) << passes(0, 1) << Moved(0, "paused", 1)
        >> Resume("0") << passes(0, 2) << goes_on(0, 3)
    )  # fmt: skip


def test_a_pause_that_is_asked_for_comes_before_the_next_no_op():  # R-E07, R-D11
    assert (
        started([JOB, NOOP, JOB])
        >> Pause("0") << Moved(0, "running", 0, text=Reason.plain("pauses after its current action"))
        >> ends(0) << Done(0, 0) << Moved(0, "paused", 0)
        >> Resume("0") << passes(0, 1) << goes_on(0, 2)
    )  # fmt: skip
