"""Stories of flows that wait for each other at synchronisation tags (§5.5.4, R-E04, reading 26)."""

from kit.engine import play_lines
from kit.engine.play import Play
from kit.plans import build, flow_program
from onika.engine.news import Abort, Finished, Killed, Run, Settled, Spawned, TurnedOn
from onika.engine.orders import Began, Done, End, Kill, Launch, Moved, Settle, Switch, Together
from onika.wire.plan import Do, Halt, Meet
from onika.wire.steer import Pass
from onika.words.reason import Reason

FREE = build.job("move", trigger="move")
MEET = build.job("move", trigger="move", synch_tag="meet")
LATER = build.job("move", trigger="move", synch_tag="later")
ENDED = "flow 1 has ended and will not come"


def started(*flows):
    """A run in the first action of each flow, whose tasks are all ON."""
    numbers = range(len(flows))
    play = Play(build.engine(*flows)) >> Run() << build.spawns(*flows) >> [Spawned(flow, "move") for flow in numbers]
    play = play << Together("", tuple(numbers)) if len(flows) > 1 else play
    for flow in numbers:
        play = play << begins(flow, 0)
    return play >> [TurnedOn(flow, "move") for flow in numbers]


def begins(flow, index):
    return [Switch(flow, (), (Launch("move", "", 100.0),)), Began(flow, index)]


def together(index, *flows):
    """All go on at the tag; the last one to come has not waited."""
    waiting = flows[:-1]
    switches = {flow: begins(flow, index) for flow in flows}
    for flow in waiting:
        switches[flow].append(Moved(flow, "running", index))
    return [Together("meet", tuple(sorted(flows))), *(order for flow in sorted(flows) for order in switches[flow])]


def waits(flow, *others, after=0, text=""):
    return Moved(flow, "waiting", after, "meet", others, text)


def test_a_tag_holds_a_flow_until_its_twin_arrives_and_both_begin_together():  # R-E04
    play = started([FREE, MEET], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << together(1, 0, 1)
    )  # fmt: skip


def test_three_flows_wait_for_the_last_of_them():  # reading 26
    play = started([FREE, MEET], [FREE, MEET], [FREE, MEET])
    assert (
        play
        >> Finished(2, "move") << Done(2, 0) << waits(2, 0, 1)
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << together(1, 0, 2, 1)
    )  # fmt: skip


def test_a_flow_without_the_tag_is_not_waited_for():
    play = started([FREE, MEET], [FREE], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 2)
        >> Finished(2, "move") << Done(2, 0) << together(1, 0, 2)
    )  # fmt: skip


def test_a_tag_on_the_first_action_holds_it():
    assert (
        Play(build.engine([MEET], [FREE, MEET]))
        >> Run() << build.spawns([MEET], [FREE, MEET])
        >> [Spawned(0, "move"), Spawned(1, "move")] << waits(0, 1, after=-1) << begins(1, 0)
        >> TurnedOn(1, "move")
        >> Finished(1, "move") << Done(1, 0) << Together("meet", (0, 1))
        << begins(0, 0) << Moved(0, "running", 0) << begins(1, 1)
    )  # fmt: skip


def test_repeated_tags_pair_in_their_order():  # reading 26
    assert (
        met([FREE, MEET, MEET], [FREE, MEET, MEET])
        >> Finished(1, "move") << Done(1, 1) << waits(1, 0, after=1)
        >> Finished(0, "move") << Done(0, 1) << together(2, 1, 0)
    )  # fmt: skip


def test_those_who_begin_together_do_so_at_the_tag_where_they_met_though_one_waits_at_the_next():  # R-X03
    assert (
        play_lines.opened([FREE, build.noop("meet"), LATER], [FREE, MEET], [MEET, LATER])
        >> Spawned(2, "move") << Moved(2, "waiting", -1, "meet", (0, 1)) << Together("", (0, 1))
        << begins(0, 0) << begins(1, 0)
        >> play_lines.ends(0) << Done(0, 0) << waits(0, 1)
        >> play_lines.ends(1) << Done(1, 0) << play_lines.passes(0, 1) << Moved(0, "waiting", 1, "later", (2,))
        << Together("meet", (1, 2)) << begins(1, 1) << play_lines.goes_on(2, 0)
        >> play_lines.ends(2) << Done(2, 0) << Together("later", (0, 2)) << play_lines.goes_on(0, 2) << begins(2, 1)
    )  # fmt: skip


def test_a_flow_that_waits_for_an_ended_one_is_reported():  # reading 26
    assert (
        met([FREE, MEET, MEET], [FREE, MEET])
        >> Finished(0, "move") << Done(0, 1) << waits(0, 1, after=1)
        >> Finished(1, "move") << Done(1, 1) << Moved(1, "done", 1) << waits(0, 1, after=1, text=ENDED)
    )  # fmt: skip


def test_a_flow_that_comes_to_wait_for_an_ended_one_is_reported_and_can_be_let_pass():  # reading 26, R-E07
    assert (
        met([FREE, MEET, MEET], [FREE, MEET])
        >> Finished(1, "move") << Done(1, 1) << Moved(1, "done", 1)
        >> Finished(0, "move") << Done(0, 1) << waits(0, 1, after=1, text=ENDED)
        >> Pass("0") << play_lines.goes_on(0, 2)
        >> play_lines.ends(0) << Done(0, 2) << Moved(0, "done", 2) << Settle()
    )  # fmt: skip


def test_flows_may_end_at_the_instant_at_which_they_meet():  # R-E14
    last = build.noop("meet")
    assert (
        play_lines.opened([FREE, last], [FREE, last])
        >> Spawned(1, "move") << Together("", (0, 1)) << begins(0, 0) << begins(1, 0)
        >> play_lines.ends(1) << Done(1, 0) << waits(1, 0)
        >> play_lines.ends(0) << Done(0, 0) << play_lines.passes(0, 1) << Moved(0, "done", 1)
        << play_lines.passes(1, 1) << Moved(1, "done", 1) << Settle()
    )  # fmt: skip


def test_a_tag_that_no_other_flow_has_holds_nobody():  # reading 27
    assert (
        started([FREE, MEET])
        >> Finished(0, "move") << Done(0, 0) << begins(0, 1)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 1) << Moved(0, "done", 1) << Settle()
        >> Settled() << Kill(0, "move")
        >> Killed(0, "move") << End(True)
    )  # fmt: skip


def test_a_waiting_flow_can_be_aborted():  # R-E07
    play = started([FREE, MEET], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Abort(Reason.plain("stop")) << Kill(0, "move") << Kill(1, "move")
        >> Killed(0, "move")
        >> Killed(1, "move") << End(False, Reason.plain("stop"))
    )  # fmt: skip


def test_a_tag_in_loops_pairs_round_by_round():  # reading 26
    loop = flow_program.program(flow_program.bottom("round", Meet("meet"), Do(0)))
    flows = build.flow([FREE], loop), build.flow([FREE], loop)
    both = [Together("meet", (0, 1)), *begins(0, 0), Moved(0, "running", 0), *begins(1, 0)]
    play = play_lines.opened(*flows) >> Spawned(1, "move") << waits(0, 1, after=-1) << both
    for _ in range(2):
        play = play >> play_lines.ends(0, loop=True) << Done(0, 0) << waits(0, 1)
        play = play >> play_lines.ends(1, loop=True) << Done(1, 0) << both
    assert (
        play
        >> play_lines.ends(1) << Done(1, 0) << Moved(1, "done", 0)
        >> play_lines.ends(0, loop=True) << Done(0, 0) << waits(0, 1, text=ENDED)
    )  # fmt: skip


def test_who_waits_for_whom_can_be_asked_at_any_time():  # R-X03
    play = started([FREE, MEET], [FREE, MEET]) >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
    first, second = play.position(0), play.position(1)
    assert (first.state, first.action, first.tag, first.waits_for) == ("waiting", 0, "meet", ("1",))
    assert (second.state, second.tag, second.waits_for) == ("running", "", ())


def test_flows_that_meet_for_ever_without_taking_time_are_aborted():
    forever = flow_program.program(flow_program.bottom("round", Meet("meet"), Do(0)))
    flow = build.flow([play_lines.NOOP, FREE], (*forever[:-1], Do(1), Halt()))
    engine = build.engine(flow, flow)
    orders = [order for news in (Run(), Spawned(0, "move"), Spawned(1, "move")) for order in engine.feed(news)]
    assert orders[-2:] == [Kill(0, "move"), Kill(1, "move")]
    orders = engine.feed(Killed(0, "move")) + engine.feed(Killed(1, "move"))
    assert orders == [End(False, Reason.of("engine.meet_for_ever"))]


def met(*flows):
    """The story of two flows that have met at their second actions, which run."""
    return (
        started(*flows)
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << together(1, 0, 1)
        >> [TurnedOn(0, "move"), TurnedOn(1, "move")]
    )  # fmt: skip


def test_a_flow_that_waited_and_is_killed_waits_for_nobody():  # R-X03
    play = started([FREE, MEET], [FREE, MEET]) >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
    position = (play >> Abort(Reason.plain("stop")) << Kill(0, "move") << Kill(1, "move")).position(0)
    assert (position.state, position.tag, position.waits_for) == ("killing", "", ())
