"""Spawns and exchanges that wait for a gap."""

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.labs.module_source import COUNTER, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.execution.deferred import PATIENCE_NS

MS = 1_000_000


@pytest.fixture
def rig():
    """A unit on which a task of 100 Hz is ON: gaps of 10 ms."""
    return ExecutiveRig().spawn("busy", COUNTER, aliases={"N": "BUSY"}).switch(on=["busy"]).run(0)


def late(rig, source=COUNTER, task="one", cost=3 * MS, init=0, **given):
    return rig.spawn_of(task, source, cost_ns=cost, init_ns=init, **given)


def work(rig, now, steps=3):
    """So many steps, as long as nothing is said; what they led to."""
    rig.now = now
    for _ in range(steps):
        events = rig.executive.work(now)
        rig.news += [(now, event) for event in events]
        if events:
            return [type(event).__name__ for event in events]
    return []


def state(rig, task="one"):
    return rig.task(task).state if (HOME, task) in rig.executive.tasks else None


def test_where_nothing_is_on_a_spawn_is_carried_out_at_once():  # law 21
    rig = ExecutiveRig()
    rig.do(late(rig))
    assert (state(rig), rig.executive.has_work) == (State.OFF, False)


def test_without_a_cost_a_spawn_is_carried_out_at_once(rig):  # law 21
    rig.do(late(rig, cost=0))
    assert state(rig) is State.OFF


def test_beside_a_task_that_is_on_it_waits_for_room(rig):  # law 21
    rig.do(late(rig))
    assert (state(rig), rig.executive.has_work) == (None, True)
    assert work(rig, 8 * MS) == []
    assert work(rig, 7 * MS) == ["Initialised"]
    assert (state(rig), rig.executive.has_work) == (State.OFF, False)


def test_compiling_loading_and_init_are_steps_of_their_own(rig):  # law 21
    rig.do(late(rig, cost=12 * MS, init=5 * MS))
    assert work(rig, 4 * MS) == []
    assert work(rig, 3 * MS, steps=2) == []
    assert state(rig) is None
    assert work(rig, 6 * MS) == []
    assert work(rig, 5 * MS, steps=1) == ["Initialised"]


def test_the_init_of_the_module_at_work_tells_of_that_of_its_successor(rig):  # law 21
    rig.task("busy").init_took_ns = 6 * MS
    rig.do(command.Swap(late(rig, COUNTER, "busy", cost=2 * MS, aliases={"N": "BUSY"})))
    assert work(rig, 5 * MS) == []
    assert work(rig, 4 * MS, steps=1) == ["Swapped"]


def test_without_a_gap_it_is_refused_with_the_numbers(rig):  # law 21
    rig.do(late(rig, cost=31 * MS // 10))
    for now in (92 * MS // 10, 9500_000):
        assert work(rig, now) == []
    rig.run(PATIENCE_NS + 9 * MS)
    assert work(rig, PATIENCE_NS + 95 * MS // 10) == ["Refused"]
    ways = "another processing unit, or the tasks that cycle here OFF for a moment, or slower"
    assert rig.news_of(news.Refused)[-1] == news.Refused(
        HOME, "one", "spawn", f"needs 3.1 ms; the largest gap here is 0.8 ms; ways out: {ways}"
    )
    assert not rig.executive.has_work


def test_each_piece_has_its_own_patience(rig):  # law 21
    rig.do(late(rig, cost=6 * MS, init=3 * MS)).run(1500 * MS)
    assert work(rig, 1501 * MS, steps=2) == []  # loaded
    for now in range(1509, 3400, 10):
        rig.run(now * MS)
        assert work(rig, now * MS) == []
    assert rig.executive.has_work
    assert work(rig.run(3400 * MS), 3401 * MS) == ["Initialised"]


def test_a_rate_that_changes_between_the_pieces_of_an_exchange_stays(rig):  # R-A04, law 21
    rig.do(command.Swap(late(rig, COUNTER, "busy", cost=6 * MS, init=3 * MS, aliases={"N": "BUSY"})))
    work(rig, MS, steps=2)
    rig.switch(rates=[("busy", 50.0)])
    assert work(rig, 2 * MS) == ["Swapped"]
    assert (rig.task("busy").period_ns, rig.task("busy").module.dt) == (20 * MS, 0.02)


def test_the_first_piece_for_which_there_is_room_is_done(rig):  # law 21
    rig.do(late(rig, task="big", cost=9 * MS)).do(late(rig, task="small", cost=MS))
    work(rig, 5 * MS)
    assert (state(rig, "big"), state(rig, "small")) == (None, State.OFF)


def test_what_goes_off_makes_room(rig):  # law 21
    rig.do(late(rig, cost=900 * MS)).switch(off=["busy"])
    assert work(rig, 5 * MS) == ["Initialised"]


def test_a_module_that_does_not_load_is_refused_when_its_time_comes(rig):  # R-B07
    rig.do(late(rig, source="class :")).do(command.Reinit(HOME, "one"))
    assert work(rig, MS) == ["Refused", "Refused"]
    assert [event.command for event in rig.news_of(news.Refused)] == ["spawn", "reinit"]


# What comes meanwhile


def test_commands_for_a_task_that_is_still_to_come_wait_behind_it_in_order(rig):  # law 2
    source = module("    def get(self, name):\n        return name\n    def set(self, name, value):\n        pass")
    rig.do(late(rig, source))
    rig.do(command.Reinit(HOME, "one")).switch(on=["one"]).do(command.Get(HOME, "one", "x"))
    rig.do(command.Rank(HOME, (("one", 5), ("busy", 2)))).switch(off=["one"])
    assert rig.task("busy").spawn.rank == 2
    assert work(rig, MS) == ["Initialised", "Reinitialised", "Changed", "Got", "Changed"]
    assert (state(rig), rig.task("one").spawn.rank) == (State.OFF, 5)


def test_the_rest_of_a_switch_does_not_wait(rig):  # law 21
    rig.do(late(rig)).switch(off=["busy"], on=["one"], rates=[("one", 50.0)])
    assert rig.task("busy").state is State.OFF
    assert work(rig, MS) == ["Initialised", "Changed"]
    assert (state(rig), rig.task("one").period_ns) == (State.ON, 20 * MS)


def test_a_kill_takes_a_spawn_back(rig):  # law 21
    rig.do(late(rig)).switch(on=["one"]).do(command.Kill(HOME, "one"))
    assert rig.news[-1][1] == news.Changed(HOME, "one", "KILLED", 0)
    assert (rig.executive.has_work, work(rig, MS)) == (False, [])


def test_a_second_spawn_of_one_name_is_refused(rig):  # R-A06
    rig.do(late(rig)).do(late(rig))
    assert rig.news_of(news.Refused)[-1].reason == "a task of this name is on its way already"
    assert work(rig, MS) == ["Initialised"]


def test_after_a_kill_the_same_name_may_come_again(rig):  # law 21
    rig.do(late(rig)).do(command.Kill(HOME, "one")).do(late(rig))
    assert work(rig, MS) == ["Initialised"]


def test_a_stop_drops_what_waits(rig):  # law 27
    rig.do(late(rig)).do(command.Stop())
    assert rig.news_of(news.Refused)[-1].reason == "this unit was stopped"
    assert work(rig, MS) == []


# Exchanges


def test_an_exchange_waits_too_and_the_old_module_works_on(rig):  # R-X15, law 21
    takes = COUNTER.replace("+= 1", "+= 100") + "\n    def take(self, old):\n        pass"
    rig.do(command.Swap(late(rig, takes, "busy", cost=8 * MS, init=2 * MS, aliases={"N": "BUSY"})))
    assert rig.run(10 * MS)["BUSY"] == 2
    assert work(rig, 13 * MS, steps=2) == []
    assert rig.run(20 * MS)["BUSY"] == 3
    assert work(rig, 27 * MS) == ["Swapped"]
    assert rig.run(30 * MS)["BUSY"] == 103
    assert rig.task("busy").slot.missed == 0


def test_the_old_module_is_turned_off_at_once_while_an_exchange_waits(rig):  # law 21
    rig.do(command.Swap(late(rig, COUNTER, "busy", aliases={"N": "BUSY"}))).switch(off=["busy"])
    assert rig.task("busy").state is State.OFF
    assert work(rig, MS) == ["Swapped"]
    assert rig.task("busy").state is State.OFF


def test_a_kill_takes_an_exchange_back(rig):  # law 21
    rig.do(command.Swap(late(rig, COUNTER, "busy", aliases={"N": "BUSY"}))).do(command.Kill(HOME, "busy"))
    assert rig.news_of(news.Refused)[-1].command == "swap"
    assert (rig.executive.has_work, rig.executive.tasks) == (False, {})


def test_an_exchange_of_a_task_that_is_still_to_come_follows_it(rig):  # law 21
    rig.do(late(rig)).do(command.Swap(late(rig, COUNTER, cost=3 * MS)))
    assert work(rig, MS) == ["Initialised"]
    assert rig.executive.has_work
    assert work(rig, MS) == ["Swapped"]


@settings(deadline=None, max_examples=examples(60))
@given(st.lists(st.tuples(st.integers(1, 12), st.integers(0, 11)), max_size=5), st.integers(5, 20))
def test_no_task_that_is_on_misses_a_cycle_whatever_comes(pieces, period):  # law 21
    """Each step takes exactly what it was expected to take; `work` is asked at every millisecond of rest."""
    rig = ExecutiveRig().spawn("busy", COUNTER, aliases={"N": "BUSY"}, frequency=1000.0 / period).switch(on=["busy"])
    needs = {}
    for number, (cost, init) in enumerate(pieces):
        init_ms = min(init, cost - 1)
        needs[f"t{number}"] = [init_ms or cost, cost - init_ms, cost - init_ms]
        rig.do(late(rig, task=f"t{number}", cost=cost * MS, init=init_ms * MS, aliases={"N": f"N{number}"}))
    worst = {name: max(each) for name, each in needs.items()}
    while rig.executive.has_work and rig.now < 3 * PATIENCE_NS:
        rig.run(rig.now)
        before = steps_left(rig)
        events = rig.executive.work(rig.now)
        after = steps_left(rig)
        moved = [name for name, left in before.items() if after.get(name) != left]
        refused = any(isinstance(event, news.Refused) for event in events)
        rig.now += max(0 if refused or not moved else needs[moved[0]].pop() * MS, MS)
    rig.run(rig.now)
    assert rig.task("busy").slot.missed == 0
    for name, most in worst.items():
        assert ((HOME, name) in rig.executive.tasks) == (most <= period)


def steps_left(rig):
    """What is compiled and loaded of everything that waits."""
    return {piece.address[1]: (piece.code is None, piece.task is None) for piece in rig.executive._deferred._pieces}
