"""Stories of nested parallel applications: begun together, awaited together, with tags of their own (R-D13)."""

import pytest

from kit.engine.play import Play
from kit.engine.play_lines import JOB, NOOP, begins, ends, goes_on, opened, passes, started
from kit.plans import build
from kit.plans.flow_program import bottom, nested, program
from onika.engine.news import Cleared, Failed, Killed, Run, Settled, Spawned, TurnedOn
from onika.engine.orders import Clear, Done, End, Kill, Moved, Off, Order, RunNote, Settle, Together
from onika.wire.plan import Do, Halt, Meet
from onika.wire.steer import Pass, Pause, Recover, Resume, Skip
from onika.words.reason import Reason

ONE = (Do(0), Halt())


def child(*jobs, script=ONE, parent=0):
    return build.flow(jobs or [JOB], script, parent)


def parent(jobs, *parts):
    return build.flow(jobs, program(*parts))


def joining(flow, index, *others):
    return Moved(flow, "joining", index, waits_for=others)


def done(flow, index):
    return Moved(flow, "done", index)


def forked(flow, index, *children) -> list[Order]:
    """The flow goes on with an action; the others begin their first one with it."""
    orders = [Together("", (flow, *children)), *begins(flow, index)]
    return orders + [order for each in children for order in goes_on(each, 0)]


SIMPLE = parent([JOB, JOB, JOB], Do(0), nested([(1, 0)], Do(1)), Do(2))


def test_the_flows_of_a_nested_application_begin_together_and_what_follows_waits_for_all():  # R-D13
    assert (
        started(SIMPLE, child())
        >> ends(0) << Done(0, 0) << forked(0, 1, 1)
        >> ends(0) << Done(0, 1) << joining(0, 1, 1)
        >> ends(1) << Done(1, 0) << done(1, 0) << goes_on(0, 2)
        >> ends(0) << Done(0, 2) << done(0, 2) << Settle()
    )  # fmt: skip


def test_who_comes_to_the_end_last_waits_for_nobody():  # R-D13
    assert (
        started(SIMPLE, child())
        >> ends(0) << Done(0, 0) << forked(0, 1, 1)
        >> ends(1) << Done(1, 0) << done(1, 0)
        >> ends(0) << Done(0, 1) << begins(0, 2)
    )  # fmt: skip


def test_a_nested_application_in_a_loop_is_begun_in_each_round():  # R-D13, R-E05
    flow = parent([JOB, JOB], bottom("round", nested([(1, 0)], Do(0)), Do(1)))
    play = opened(flow, child()) >> Spawned(1, "move")
    play = play << [Together("", (0, 1)), *begins(0, 0), *goes_on(1, 0)]
    for _ in range(2):
        play = (
            play
            >> ends(1) << Done(1, 0) << done(1, 0)
            >> ends(0) << Done(0, 0) << begins(0, 1)
            >> ends(0, loop=True) << Done(0, 1) << forked(0, 0, 1)
        )  # fmt: skip
    assert play


def test_one_flow_serves_several_nested_applications_with_a_stretch_for_each():  # R-D13
    stretches = child(JOB, JOB, script=(Do(0), Halt(), Do(1), Halt()))
    flow = parent([JOB, JOB, JOB], nested([(1, 0)], Do(0)), Do(1), nested([(1, 2)], Do(2)))
    play = opened(flow, stretches) >> Spawned(1, "move") << [Together("", (0, 1)), *begins(0, 0), *goes_on(1, 0)]
    play = play >> ends(1) << Done(1, 0) << done(1, 0) >> ends(0) << Done(0, 0) << begins(0, 1)
    assert (
        play
        >> ends(0) << Done(0, 1) << Together("", (0, 1)) << begins(0, 2) << goes_on(1, 1)
        >> ends(1) << Done(1, 1) << done(1, 1)
        >> ends(0) << Done(0, 2) << done(0, 2) << Settle()
    )  # fmt: skip


TAGGED = build.job("move", trigger="move", synch_tag="meet a")
MEETS = (Do(0), Meet("meet a"), Do(1), Halt())


def test_the_flows_of_a_nested_application_meet_at_its_tags_in_every_round_anew():  # R-D13, readings 26 and 27
    flow = parent([JOB, JOB], bottom("round", nested([(1, 0)], Do(0), Meet("meet a"), Do(1))))
    play = opened(flow, child(JOB, JOB, script=MEETS)) >> Spawned(1, "move")
    play = play << [Together("", (0, 1)), *begins(0, 0), *goes_on(1, 0)]
    for _ in range(2):
        play = (
            play
            >> ends(1) << Done(1, 0) << Moved(1, "waiting", 0, "meet a", (0,))
            >> ends(0) << Done(0, 0) << Together("meet a", (0, 1)) << begins(0, 1) << goes_on(1, 1)
            >> ends(1) << Done(1, 1) << done(1, 1)
            >> ends(0, loop=True) << Done(0, 1) << forked(0, 0, 1)
        )  # fmt: skip
    assert play


def test_a_visit_that_was_let_pass_in_one_round_does_not_count_in_the_next():  # R-D13, reading 26
    flow = parent([JOB, JOB], bottom("round", nested([(1, 0)], Do(0), Meet("meet a"), Do(1))))
    play = opened(flow, child(JOB, JOB, script=MEETS)) >> Spawned(1, "move")
    play = play << [Together("", (0, 1)), *begins(0, 0), *goes_on(1, 0)]
    skipped = RunNote(1, Reason.plain("test.appl flow 1 action 0: left by the user"))
    assert (
        play
        >> ends(0) << Done(0, 0) << Moved(0, "waiting", 0, "meet a", (1,))
        >> Pass("0") << goes_on(0, 1) >> TurnedOn(1, "move")
        >> Skip("1", 1) << skipped << begins(1, 1, ["move"])
        >> ends(1) << Done(1, 1) << done(1, 1)
        >> ends(0, loop=True) << Done(0, 1) << forked(0, 0, 1)
        >> ends(1) << Done(1, 0) << Moved(1, "waiting", 0, "meet a", (0,))
    )  # fmt: skip


def test_nested_applications_nest():  # R-D13
    flow = parent([JOB, JOB], nested([(1, 0)], Do(0)), Do(1))
    middle = child(JOB, JOB, script=program(nested([(2, 0)], Do(0)), Do(1)))
    play = opened(flow, middle, child(parent=1)) >> Spawned(2, "move")
    play = play << Together("", (0, 1, 2)) << begins(0, 0) << goes_on(1, 0) << goes_on(2, 0)
    assert (
        play
        >> ends(0) << Done(0, 0) << joining(0, 0, 1)
        >> ends(1) << Done(1, 0) << joining(1, 0, 2)
        >> ends(2) << Done(2, 0) << done(2, 0) << goes_on(1, 1)
        >> ends(1) << Done(1, 1) << done(1, 1) << goes_on(0, 1)
    )  # fmt: skip


def test_flow_0_of_a_nested_application_may_have_nothing_to_do_and_still_waits_for_the_others():  # R-D13
    flow = parent([JOB, NOOP, JOB], Do(0), nested([(1, 0)], Do(1)), Do(2))
    assert (
        started(flow, child())
        >> ends(0) << Done(0, 0) << passes(0, 1) << joining(0, 1, 1) << goes_on(1, 0)
        >> ends(1) << Done(1, 0) << done(1, 0) << goes_on(0, 2)
    )  # fmt: skip


def test_flow_0_that_has_nothing_to_do_waits_for_grandchildren_as_well():  # R-D13
    flow = parent([JOB, JOB], Do(0), nested([(1, 0)]), Do(1))
    middle = child(NOOP, script=program(nested([(2, 0)], Do(0))))
    grandchild = child(parent=1)
    play = opened(flow, middle, grandchild) >> Spawned(2, "move") << begins(0, 0) >> ends(0) << Done(0, 0)
    play = play << joining(0, 0, 1) << passes(1, 0) << joining(1, 0, 2) << goes_on(2, 0)
    assert play >> ends(2) << Done(2, 0) << done(2, 0) << done(1, 0) << goes_on(0, 1)


def test_flows_that_end_at_one_instant_let_the_one_above_them_go_on_once():  # R-D13
    flow = parent([JOB, JOB, JOB, JOB], Do(0), nested([(1, 0), (2, 0)], Do(1)), Do(2), Do(3))
    last = (Do(0), Meet("meet a"), Do(1), Halt())
    children = child(JOB, NOOP, script=last), child(JOB, NOOP, script=last)
    assert (
        started(flow, *children)
        >> ends(0) << Done(0, 0) << forked(0, 1, 1, 2)
        >> ends(0) << Done(0, 1) << joining(0, 1, 1, 2)
        >> ends(1) << Done(1, 0) << Moved(1, "waiting", 0, "meet a", (2,))
        >> ends(2) << Done(2, 0) << passes(1, 1) << done(1, 1) << passes(2, 1) << done(2, 1) << goes_on(0, 2)
        >> ends(0) << Done(0, 2) << begins(0, 3)
    )  # fmt: skip


def test_a_nested_application_of_no_ops_takes_no_time():  # R-D13, R-D11
    flow = parent([JOB, NOOP, JOB], Do(0), nested([(1, 0)], Do(1)), Do(2))
    play = opened(flow, child(NOOP)) >> Spawned(0, "move") << begins(0, 0) >> ends(0) << Done(0, 0) << passes(0, 1)
    assert play << joining(0, 1, 1) << passes(1, 0) << done(1, 0) << goes_on(0, 2)


def test_a_flow_that_is_never_begun_is_killed_with_the_others():  # R-E02, R-E14
    never = build.flow([JOB, JOB], (Do(0), Halt(), *program(nested([(1, 0)], Do(1)))), None)
    assert (
        started(never, child())
        >> ends(0) << Done(0, 0) << done(0, 0) << Settle()
        >> Settled() << Kill(0, "move") << Kill(1, "move")
        >> Killed(0, "move")
        >> Killed(1, "move") << End(True)
    )  # fmt: skip


# Steered


def joined():
    """Flow 0 waits for flow 1."""
    return (
        started(SIMPLE, child())
        >> ends(0)
        << Done(0, 0)
        << forked(0, 1, 1)
        >> ends(0)
        << Done(0, 1)
        << joining(0, 1, 1)
    )


def test_a_flow_that_waits_for_nested_ones_can_be_paused_and_goes_on_when_both_say_so():  # R-E07
    assert (
        joined()
        >> Pause("0") << Moved(0, "paused", 1)
        >> ends(1) << Done(1, 0) << done(1, 0)
        >> Resume("0") << goes_on(0, 2)
    )  # fmt: skip


def test_a_flow_that_waits_for_nested_ones_waits_again_after_a_pause():  # R-E07
    assert (
        joined()
        >> Pause("0") << Moved(0, "paused", 1)
        >> Resume("0") << joining(0, 1, 1)
        >> ends(1) << Done(1, 0) << done(1, 0) << goes_on(0, 2)
    )  # fmt: skip


def test_a_nested_flow_that_pauses_is_waited_for():  # R-E07
    assert (
        joined()
        >> Pause("1") << Moved(1, "running", 0, text=Reason.plain("pauses after its current action"))
        >> ends(1) << Done(1, 0) << Moved(1, "paused", 0)
        >> Resume("1") << done(1, 0) << goes_on(0, 2)
    )  # fmt: skip


def test_a_nested_flow_that_was_to_pause_before_its_first_action_does_so_when_it_is_begun():  # R-E07
    flow = parent([JOB, JOB], Do(0), nested([(1, 0)], Do(1)))
    assert (
        opened(flow, child())
        >> Pause("1") << Moved(1, "spawning", -1, text=Reason.plain("pauses before its first action"))
        >> Spawned(1, "move") << begins(0, 0)
        >> ends(0) << Done(0, 0) << Moved(1, "paused", -1) << begins(0, 1)
        >> ends(0) << Done(0, 1) << joining(0, 1, 1)
        >> Resume("1") << goes_on(1, 0)
    )  # fmt: skip


def test_a_flow_is_let_pass_and_does_not_begin_the_nested_ones_again_before_they_end():  # R-E07, R-D13
    flow = parent([JOB, JOB], bottom("round", nested([(1, 0)], Do(0)), Do(1)))
    play = opened(flow, child()) >> Spawned(1, "move")
    play = play << [Together("", (0, 1)), *begins(0, 0), *goes_on(1, 0)]
    play = play >> ends(0) << Done(0, 0) << joining(0, 0, 1) >> Pass("0") << goes_on(0, 1)
    play = play >> ends(0, loop=True) << Done(0, 1) << joining(0, 1, 1)
    play = play.refuses(Pass("0"), "waits for flows that it is about to begin again")
    assert play >> ends(1) << Done(1, 0) << done(1, 0) << Together("", (0, 1)) << goes_on(0, 0) << goes_on(1, 0)


def test_a_flow_that_was_let_pass_does_not_end_the_application_before_the_nested_ones():  # R-E14
    play = joined() >> Pass("0") << goes_on(0, 2) >> ends(0) << Done(0, 2) << done(0, 2)
    assert play >> ends(1) << Done(1, 0) << done(1, 0) << Settle()


@pytest.mark.parametrize("to", [0, 2])
def test_nobody_is_sent_into_a_nested_parallel_application_or_out_of_it(to):  # R-E13
    play = started(SIMPLE, child()) >> ends(0) << Done(0, 0) << forked(0, 1, 1)
    assert play.refuses(Skip("0", to), "not on the same side of a nested parallel application")


def test_nobody_is_sent_to_a_stretch_that_the_flow_above_begins():  # R-E13
    stretches = child(JOB, JOB, script=(Do(0), Halt(), Do(1), Halt()))
    flow = parent([JOB, JOB], nested([(1, 0)], Do(0)), nested([(1, 2)], Do(1)))
    play = opened(flow, stretches) >> Spawned(1, "move") << [Together("", (0, 1)), *begins(0, 0), *goes_on(1, 0)]
    assert play.refuses(Skip("1", 1), "begun by the flow above it")


def test_the_next_action_of_a_flow_may_be_the_end_of_a_nested_application():  # R-E07
    play = started(SIMPLE, child()) >> ends(0) << Done(0, 0) << forked(0, 1, 1) >> TurnedOn(0, "move")
    left = RunNote(0, Reason.plain("test.appl flow 0 action 1: left by the user"))
    assert play >> Skip("0") << left << Off(0, "move") << joining(0, 1, 1)


# Errors


def stopped(flow, index):
    where = f"test.appl flow {flow} action {index}"
    return Moved(flow, "stopped", index, text=Reason.plain(f"{where}: move is in error: it broke"))


def test_a_nested_flow_in_error_is_waited_for():  # R-E08, reading 28
    assert (
        joined() >> TurnedOn(1, "move")
        >> Failed(1, "move", Reason.plain("it broke")) << stopped(1, 0)
        >> Recover("1") << Moved(1, "clearing", 0) << Clear(1, "move")
        >> Cleared(1, "move") << goes_on(1, 0)
        >> ends(1) << Done(1, 0) << done(1, 0) << goes_on(0, 2)
    )  # fmt: skip


def test_an_error_while_a_flow_waits_for_nested_ones_is_cleared_and_it_waits_on():  # R-E08
    assert (
        joined()
        >> Failed(0, "move", Reason.plain("it broke")) << stopped(0, 1)
        >> Recover("0") << Moved(0, "clearing", 1) << Clear(0, "move")
        >> Cleared(0, "move") << joining(0, 1, 1)
        >> ends(1) << Done(1, 0) << done(1, 0) << goes_on(0, 2)
    )  # fmt: skip


def test_nested_flows_may_end_while_the_one_above_is_in_error():  # R-E08
    assert (
        joined()
        >> Failed(0, "move", Reason.plain("it broke")) << stopped(0, 1)
        >> ends(1) << Done(1, 0) << done(1, 0)
        >> Recover("0") << Moved(0, "clearing", 1) << Clear(0, "move")
        >> Cleared(0, "move") << goes_on(0, 2)
    )  # fmt: skip


def test_a_nested_flow_that_fails_before_it_is_begun_is_cleared_and_does_not_begin_by_itself():  # R-E08
    text = "move.rmod: move is in error: it broke"
    assert (
        started(SIMPLE, child())
        >> Failed(1, "move", Reason.plain("it broke")) << Moved(1, "stopped", -1, text=Reason.plain(text))
        >> ends(0) << Done(0, 0) << joining(0, 0, 1)
        >> Recover("1") << Moved(1, "clearing", -1) << Clear(1, "move")
        >> Cleared(1, "move") << done(1, -1) << Together("", (0, 1)) << goes_on(0, 1) << goes_on(1, 0)
    )  # fmt: skip


def test_all_tasks_of_nested_flows_live_before_anything_begins():  # R-E02
    assert (
        Play(build.engine(SIMPLE, child()))
        >> Run() << build.spawns(SIMPLE, child())
        >> Spawned(0, "move")
        >> Spawned(1, "move") << begins(0, 0)
    )  # fmt: skip
