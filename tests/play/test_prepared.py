"""Stories of cases that are prepared, so that the next action follows at once (§5.9.2, R-E02, decision 19)."""

import pytest

from kit.engine.play import Play
from kit.engine.play_lines import JOB, NOOP, ends, opened, passes, started
from kit.plans import build
from kit.plans.flow_program import bottom, branch, nested, program, top
from onika.engine.news import Asked, Failed, Finished, Refused, Run, Spawned, SwitchedOff, TurnedOn
from onika.engine.orders import Began, Case, Done, Launch, Moved, Settle, Switch
from onika.wire.plan import Do, Rest
from onika.wire.steer import Leave, Mark, Pause, Resume, Skip
from onika.words.reason import Reason

NEXT = Switch(0, (), (Launch("move", "", 100.0),))


def case(choice, loop, arguments):
    """The case in which the action follows that is told this."""
    return Case("move", choice, loop, Switch(0, (), (Launch("move", arguments, 100.0),)))


def jobs(*arguments):
    return [build.job("move", trigger="move", arguments=each) for each in arguments]


def begun(flow, **given):
    """A run in its first action, all ON, whatever its trigger is told."""
    first = flow.jobs[0] if isinstance(flow, build.Flow) else flow[0]
    switch = Switch(0, (), (Launch("move", first.arguments, 100.0),))
    return opened(flow, **given) >> Spawned(0, "move") << switch << Began(0, 0) >> TurnedOn(0, "move")


def test_what_follows_whatever_is_returned_is_one_case():
    assert begun(jobs("1", "2")).cases(0) == [case(None, None, "2")]


def test_a_loop_has_a_case_for_each_answer_of_its_test():  # R-E05
    play = begun(build.flow(jobs("1", "2"), program(bottom("round", Do(0)), Do(1))))
    assert play.cases(0) == [case(None, False, "2"), case(None, True, "1")]


def test_a_loop_at_the_end_of_a_flow_has_a_case_for_going_on_only():
    play = begun(build.flow(jobs("1"), program(bottom("round", Do(0)))))
    assert play.cases(0) == [case(None, True, "1")]


def test_a_top_test_has_a_case_for_each_answer_and_its_body_one():  # R-E05
    play = begun(build.flow(jobs("1", "2", "3"), program(top("round", Do(0), Do(1)), Do(2))))
    assert play.cases(0) == [case(None, False, "3"), case(None, True, "2")]
    play = play >> ends(0, loop=True) << Done(0, 0) << Switch(0, (), (Launch("move", "2", 100.0),)) << Began(0, 1)
    assert (play >> TurnedOn(0, "move")).cases(0) == [case(None, None, "1")]


def test_a_branch_has_a_case_for_each_of_its_flows_but_none_for_a_value_beyond_them():  # R-D10, reading 20
    play = begun(build.flow(jobs("1", "2", "3"), program(Do(0), branch([Do(1)], [Do(2)]))))
    assert play.cases(0) == [case(0, None, "2"), case(1, None, "3")]


def test_of_two_branches_each_has_as_many_cases_as_it_has_flows():  # R-D10
    script = program(Do(0), branch([Do(1)], [Do(2)]), branch([Do(3)], [Do(4)], [Do(5)]))
    play = begun(build.flow(jobs(*"123456"), script))
    assert play.cases(0) == [case(0, None, "2"), case(1, None, "3")]


def test_of_very_many_ways_only_the_first_are_prepared_and_the_others_are_taken_all_the_same():
    ways = [[Do(index)] for index in range(1, 10)]
    play = begun(build.flow(jobs(*"1234567890"), program(Do(0), branch(*ways))))
    assert [each.choice for each in play.cases(0)] == [0, 1, 2, 3]
    assert play >> ends(0, 8) << Done(0, 0) << Switch(0, (), (Launch("move", "0", 100.0),)) << Began(0, 9)


def test_loop_and_choice_together_make_a_case_for_each_pair_that_matters():  # reading 19
    script = program(top("round", Do(0), branch([Do(1)], [Do(2)])), Do(3))
    play = begun(build.flow(jobs("1", "2", "3", "4"), script))
    assert play.cases(0) == [case(None, False, "4"), case(0, True, "2"), case(1, True, "3")]


def test_a_loop_that_is_to_be_left_has_one_case():  # R-E07
    play = begun(build.flow(jobs("1", "2"), program(bottom("round", Do(0)), Do(1))))
    play = play >> Leave("0") << Moved(0, "running", 0, text=Reason.plain("leaves the loop round at its next test"))
    assert play.cases(0) == [case(None, None, "2")]


def test_behind_no_ops_the_case_is_that_of_the_next_job():  # R-D11
    play = begun([*jobs("1"), NOOP, *jobs("2")])
    assert play.cases(0) == [case(None, None, "2")]
    orders = [Done(0, 0), *passes(0, 1), Switch(0, (), (Launch("move", "2", 100.0),), number=1), Began(0, 2)]
    assert play >> ends(0, switched=1) << orders


SCRIPTS = {
    "the end": ([], program(Do(0))),
    "a tag": ([build.job("move", trigger="move", synch_tag="meet")], ()),
    "a condition": (jobs("2"), program(bottom("round", Do(0), condition="X"), Do(1))),
    "a branch by conditions": (jobs("2", "3"), program(Do(0), branch([Do(1)], [Do(2)], conditions=("X",)))),
    "a breakpoint": (jobs("2"), program(Do(0), Rest(0), Do(1))),
    "a breakpoint under a condition": (jobs("2"), program(Do(0), Rest(0, "X"), Do(1))),
    "a breakpoint behind an application": (jobs("2"), program(Do(0), Rest(-1), Do(1))),
    "a breakpoint behind an application under a condition": (jobs("2"), program(Do(0), Rest(-1, "X"), Do(1))),
    "a breakpoint after a no-op": ([build.noop(), *jobs("2")], program(Do(0), Do(1), Rest(1), Do(2))),
    "a nested parallel application": (jobs("2"), program(Do(0), nested([(1, 0)], Do(1)))),
    "a loop without time": ([NOOP], program(Do(0), bottom("round", Do(1)))),
}


@pytest.mark.parametrize("before", SCRIPTS)
def test_what_cannot_be_foreseen_is_not_prepared(before):
    more, script = SCRIPTS[before]
    child = build.flow([JOB], program(Do(0)), 0)
    play = started(build.flow([JOB, *more], script), child) >> TurnedOn(0, "move")
    assert play.cases(0) == []


def test_a_flow_that_will_pause_has_no_case_until_the_pause_is_taken_back():  # R-E07
    play = (
        begun(jobs("1", "2"))
        >> Pause("0")
        << Moved(0, "running", 0, text=Reason.plain("pauses after its current action"))
    )
    assert play.cases(0) == []
    assert (play >> Resume("0") << Moved(0, "running", 0, text=Reason.plain("does not pause"))).cases(0) == [
        case(None, None, "2")
    ]


def test_a_breakpoint_set_in_the_run_takes_the_case_away():  # R-E07
    assert (begun(jobs("1", "2")) >> Mark("0", 0)).cases(0) == []


def test_a_flow_that_does_not_run_has_no_case():
    play = (
        begun(jobs("1", "2"))
        >> Pause("0")
        << Moved(0, "running", 0, text=Reason.plain("pauses after its current action"))
    )
    assert (play >> ends(0) << Done(0, 0) << Moved(0, "paused", 0)).cases(0) == []
    assert opened(jobs("1", "2")).cases(0) == []


def test_nothing_is_prepared_before_everybody_is_on():
    job = build.job("move", "puma", trigger="move")
    play = Play(build.engine([job, job])) >> Run() << build.spawns([job]) >> Spawned(0, "move")
    switch = Switch(0, (), (Launch("move", "", 100.0), Launch("puma", "", 100.0)))
    play = play >> Spawned(0, "puma") << switch << Began(0, 0) >> TurnedOn(0, "puma")
    before = play.cases(0)
    assert (before, (play >> TurnedOn(0, "move")).cases(0)) == ([], [Case("move", None, None, NEXT)])


def test_an_action_with_several_triggers_or_none_has_no_case():  # reading 16
    job = build.job("move", "timer", trigger="move")
    engine = build.engine([job, job], other_triggers=[(0, "timer")])
    hold = build.engine([build.job("puma"), JOB])
    for each, tasks in ((engine, ("move", "timer")), (hold, ("puma", "move"))):
        first = [TurnedOn(0, task) for task in tasks if task != "move" or "timer" in tasks]
        for news in (Run(), *(Spawned(0, task) for task in tasks), *first):
            each.feed(news)
        assert each.positions()[0].state == "running"
        assert each.cases(0) == []


def test_a_case_takes_the_trigger_for_off_and_leaves_the_others_alone():  # law 6
    engine = build.engine(
        [
            build.job("move", "puma", "pd", trigger="move"),
            build.job("grip", "puma", trigger="grip", rates={"puma": 50.0}),
        ]
    )
    spawned = (Spawned(0, task) for task in ("move", "puma", "pd", "grip"))
    for news in (Run(), *spawned, *(TurnedOn(0, task) for task in ("move", "puma", "pd"))):
        engine.feed(news)
    switch = Switch(0, ("pd",), (Launch("grip", "", 100.0),), (("puma", 50.0),))
    assert engine.cases(0) == [Case("move", None, None, switch)]
    done, carried_out, began = engine.feed(Finished(0, "move", switched=3))
    assert (done, began) == (Done(0, 0), Began(0, 1))
    assert carried_out == Switch(0, switch.off, switch.on, switch.kept_rates, number=3)


def test_a_case_that_was_carried_out_is_told_by_its_number_and_counts_as_the_switch():
    play = begun(jobs("1", "2", "3"))
    second, third = Launch("move", "2", 100.0), Launch("move", "3", 100.0)
    assert (
        play
        >> ends(0, switched=1) << Done(0, 0) << Switch(0, (), (second,), number=1) << Began(0, 1)
        >> ends(0, switched=2) << Done(0, 1) << Switch(0, (), (third,), number=2) << Began(0, 2)
        >> ends(0) << Done(0, 2) << Moved(0, "done", 2) << Settle()
    )  # fmt: skip


@pytest.mark.parametrize(("choice", "loop"), [(0, False), (0, True), (1, False), (1, True)])
def test_a_case_says_what_then_happens(choice, loop):  # reading 19
    script = program(top("round", Do(0), branch([Do(1)], [Do(2)])), Do(3))
    play = begun(build.flow(jobs("1", "2", "3", "4"), script))
    fits = [each for each in play.cases(0) if each.choice in (None, choice) and each.loop in (None, loop)]
    assert len(fits) == 1
    switch = fits[0].switch
    index = 3 if not loop else 1 + choice
    following = Switch(0, switch.off, switch.on, switch.kept_rates, number=1)
    assert play >> ends(0, choice, loop, switched=1) << Done(0, 0) << following << Began(0, index)


def test_the_revision_changes_with_everything_that_may_change_the_cases():
    engine = build.engine(build.flow([JOB, JOB, JOB], program(bottom("round", Do(0), Do(1)), Do(2))))
    for news in (Run(), Spawned(0, "move"), TurnedOn(0, "move")):
        engine.feed(news)
    for news in (
        Leave("0"),
        Pause("0"),
        Resume("0"),
        Mark("0", 1),
        Mark("0", 1, is_set=False),
        Skip("0"),
        TurnedOn(0, "move"),
        Finished(0, "move"),
    ):
        before, cases = engine.revision(0), engine.cases(0)
        engine.feed(news)
        if engine.cases(0) != cases or not isinstance(news, TurnedOn):
            assert engine.revision(0) != before, news


def test_what_changes_nothing_leaves_the_revision_as_it_is():
    engine = build.engine(jobs("1", "2"))
    for news in (Run(), Spawned(0, "move"), TurnedOn(0, "move")):
        engine.feed(news)
    before = engine.revision(0)
    for news in (TurnedOn(0, "move"), Asked(0, "move", Reason.plain("how far?")), Finished(0, "ghost")):
        engine.feed(news)
    assert engine.revision(0) == before


@pytest.mark.parametrize(
    ("news", "comes_back"),
    [
        (SwitchedOff(0, "view"), True),
        (Failed(0, "view", Reason.plain("no screen")), False),
        (Refused(0, "view", Reason.plain("broken")), False),
    ],
)
def test_a_passive_task_that_falls_silent_changes_what_follows(news, comes_back):  # reading 17
    job = build.job("move", "view", trigger="move")
    engine = build.engine([job, job], passive=[(0, "view")])
    first = [kind(0, task) for kind in (Spawned, TurnedOn) for task in ("move", "view")]
    for each in (Run(), *first):
        engine.feed(each)
    before, revision = engine.cases(0), engine.revision(0)
    engine.feed(news)
    assert engine.revision(0) != revision
    assert [[start.task for start in case.switch.on] for case in (*before, *engine.cases(0))] == [
        ["move"],
        ["move", "view"] if comes_back else ["move"],
    ]
