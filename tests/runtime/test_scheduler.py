"""What is due, in which order."""

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.runtime.scheduler import Scheduler, SlotGroup, TaskSlot


def slot(name="a", period=10, crit=0, rank=0):
    return TaskSlot((-crit, rank, name), period)


def run_all(scheduler, now):
    """The names of all slots that run at an instant at which cycles take no time."""
    names = []
    while (due := scheduler.next_due(now)) is not None:
        names.append(due.key[2])
        scheduler.done(due)
    return names


def test_nothing_is_due_on_an_empty_scheduler():
    scheduler = Scheduler()
    assert scheduler.next_release() is None
    assert scheduler.next_due(10**12) is None


def test_a_slot_is_due_at_once_and_then_on_the_common_grid():  # law 13
    scheduler, task_slot = Scheduler(), slot()
    scheduler.enter(task_slot, 7)
    releases = []
    for _ in range(4):
        releases.append(scheduler.next_release())
        assert scheduler.next_due(releases[-1]) is task_slot
        scheduler.done(task_slot)
        assert scheduler.next_due(scheduler.next_release() - 1) is None
    assert releases == [7, 10, 20, 30]


def test_slots_that_enter_together_are_due_together_and_none_is_late():  # law 2
    """The `on` of the second took until 25: the first is not late by it."""
    scheduler, first, second = Scheduler(), slot("b"), slot("a")
    scheduler.enter(first, 0)
    scheduler.enter(second, 25)
    assert scheduler.next_release() == 0
    assert run_all(scheduler, 25) == ["a", "b"]
    assert (first.missed, scheduler.next_release()) == (0, 30)


def test_slots_due_at_one_instant_run_by_deadline_criticality_rank_and_name():  # law 1
    scheduler = Scheduler()
    slots = [slot("slow", 20), slot("b"), slot("a"), slot("c", rank=-1), slot("crit", rank=9, crit=1)]
    for task_slot in slots:
        scheduler.enter(task_slot, 0)
    assert run_all(scheduler, 0) == ["crit", "c", "a", "b", "slow"]


@settings(deadline=None, max_examples=examples(50))
@given(st.permutations([slot(name, 10 * (1 + n % 2), n % 3, n % 2) for n, name in enumerate("abcdef")]))
def test_the_order_at_one_instant_does_not_depend_on_what_came_before(slots):  # law 1
    scheduler = Scheduler()
    for task_slot in slots:
        scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    assert run_all(scheduler, 20) == sorted(
        "abcdef", key=lambda n: next((s.deadline, s.key) for s in slots if s.key[2] == n)
    )


def test_a_late_slot_skips_whole_periods_and_runs_for_the_one_that_is_open():  # law 2
    scheduler, task_slot = Scheduler(), slot()
    scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    assert scheduler.next_due(45) is task_slot
    assert (task_slot.missed, task_slot.release, task_slot.deadline) == (3, 40, 50)


def test_a_slot_that_runs_within_its_period_has_missed_nothing():  # law 2
    scheduler, task_slot = Scheduler(), slot()
    scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    assert scheduler.next_due(19) is task_slot
    assert (task_slot.missed, task_slot.release) == (0, 10)


def test_a_slot_at_its_very_deadline_runs_for_the_next_period_and_only_once():  # law 2
    scheduler, task_slot = Scheduler(), slot()
    scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    assert run_all(scheduler, 20) == ["a"]
    assert (task_slot.missed, scheduler.next_release()) == (1, 30)


def test_a_late_slot_takes_its_place_by_its_new_deadline():  # laws 1, 2
    scheduler, late, fresh = Scheduler(), slot("late", 10), slot("fresh", 48)
    scheduler.enter(late, 0)
    run_all(scheduler, 0)
    scheduler.enter(fresh, 45)
    assert run_all(scheduler, 45) == ["fresh", "late"]  # 48 before 50, though the deadline of `late` was 20 once


def test_what_has_left_is_not_due_and_may_come_back():
    scheduler, task_slot = Scheduler(), slot()
    for is_in_already in (False, True):
        scheduler.enter(task_slot, 0)
        if is_in_already:
            run_all(scheduler, 0)
        scheduler.leave(task_slot)
        assert scheduler.next_release() is None
        assert scheduler.next_due(100) is None
    scheduler.enter(task_slot, 105)
    assert scheduler.next_release() == 105


def test_what_leaves_while_others_wait_their_turn_hides_nobody():
    scheduler, slots = Scheduler(), [slot(name, period=100) for name in "abc"]
    for task_slot in slots:
        scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    assert scheduler.next_due(105) is slots[0]
    scheduler.done(slots[0])
    scheduler.leave(slots[1])
    assert scheduler.next_release() == 100
    assert scheduler.next_due(105) is slots[2]


def test_a_new_slot_of_an_old_name_is_another_one():
    """A task that is killed and spawned again within a period: its old entries are still in the queue."""
    scheduler = Scheduler()
    for start in (0, 5, 7):
        task_slot = slot("same")
        scheduler.enter(task_slot, start)
        assert scheduler.next_due(start) is task_slot
        scheduler.done(task_slot)
        scheduler.leave(task_slot)
    last = slot("same")
    scheduler.enter(last, 8)
    assert scheduler.next_due(10) is last
    assert scheduler.next_due(10) is None


def test_another_period_keeps_the_common_grid():  # R-A04
    scheduler, task_slot = Scheduler(), slot(period=10)
    scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    scheduler.change(task_slot, 4, 5)
    assert scheduler.next_release() == 8
    run_all(scheduler, 8)
    assert scheduler.next_release() == 12


def test_a_release_that_is_due_survives_a_change_of_the_period():  # R-A04
    scheduler, task_slot = Scheduler(), slot(period=10)
    scheduler.enter(task_slot, 0)
    run_all(scheduler, 0)
    scheduler.change(task_slot, 25, 10)
    assert scheduler.next_due(10) is task_slot
    assert task_slot.deadline == 25


def test_a_change_of_the_period_of_what_is_not_listed_lists_nothing():  # R-A04
    scheduler, task_slot = Scheduler(), slot()
    scheduler.change(task_slot, 20, 0)
    assert scheduler.next_release() is None
    scheduler.enter(task_slot, 3)
    run_all(scheduler, 3)
    assert scheduler.next_release() == 20


@given(st.lists(st.tuples(st.integers(0, 2), st.integers(-3, 3)), max_size=8), st.integers(0, 60))
def test_another_rank_changes_the_order_and_loses_no_release(changes, at):  # law 1
    """Ranks that change between any two cycles: every slot runs once a period all the same, in the order of ranks."""
    scheduler = Scheduler()
    slots = [slot(name, rank=n) for n, name in enumerate("abc")]
    for task_slot in slots:
        scheduler.enter(task_slot, 0)
    ran = {task_slot.key[2]: [] for task_slot in slots}
    for now in range(0, 101, 10):
        pending = list(changes) if now == at // 10 * 10 else []
        order = []
        while (due := scheduler.next_due(now)) is not None:
            order.append(due.key)
            ran[due.key[2]].append(now)
            scheduler.done(due)
            while pending:
                which, rank = pending.pop()
                scheduler.rekey(slots[which], (0, rank, slots[which].key[2]))
        if now != at // 10 * 10:
            assert order == sorted(order)
    assert all(times == list(range(0, 101, 10)) for times in ran.values())


def test_another_rank_of_what_is_due_already_counts_at_once():  # law 1
    scheduler, first, second, third = Scheduler(), slot("a", rank=0), slot("b", rank=1), slot("c", rank=2)
    for task_slot in (first, second, third):
        scheduler.enter(task_slot, 0)
    assert scheduler.next_due(0) is first
    scheduler.done(first)
    scheduler.rekey(third, (0, -1, "c"))
    assert run_all(scheduler, 0) == ["c", "b"]


def test_another_rank_of_what_is_not_listed_is_taken_over_when_it_enters():  # law 1
    scheduler, task_slot, other = Scheduler(), slot("a", rank=0), slot("b", rank=1)
    scheduler.rekey(task_slot, (0, 5, "a"))
    scheduler.enter(task_slot, 0)
    scheduler.enter(other, 0)
    assert run_all(scheduler, 0) == ["b", "a"]


def test_a_slot_that_resumes_is_due_at_the_next_point_of_its_grid():  # R-F04
    scheduler, task_slot = Scheduler(), slot()
    scheduler.enter(task_slot, 7)
    assert scheduler.next_due(7) is task_slot
    scheduler.leave(task_slot)
    scheduler.resume(task_slot, 23)
    assert (scheduler.next_release(), run_all(scheduler, 29), run_all(scheduler, 30)) == (30, [], ["a"])
    assert (task_slot.deadline, task_slot.missed) == (50, 0)


def test_a_slot_that_resumes_twice_or_was_to_enter_is_due_once():
    scheduler, task_slot = Scheduler(), slot()
    scheduler.enter(task_slot, 3)
    scheduler.resume(task_slot, 3)
    scheduler.resume(task_slot, 4)
    assert (run_all(scheduler, 9), run_all(scheduler, 10), run_all(scheduler, 10)) == ([], ["a"], [])


# Groups


def grouped(*slots, now=0):
    """A scheduler on which these are due together, as groups."""
    scheduler = Scheduler()
    for each in slots:
        scheduler.enter(each, now)
    while (due := scheduler.next_due(now)) is not None:
        scheduler.done(due)
    scheduler.group([SlotGroup(together) for together in scheduler.gathered()])
    return scheduler


def test_slots_of_one_period_are_gathered_in_their_order():  # law 1
    a, b, fast = slot("a", 20), slot("b", 20), slot("fast", 10)
    scheduler = grouped(b, fast, a)
    assert [(release, [each.key[2] for each in group.slots]) for release, _, group in scheduler.groups] == [
        (10, ["fast"]), (20, ["a", "b"]),
    ]  # fmt: skip
    assert scheduler.next_release() == 10


def test_what_is_due_now_or_not_together_is_not_gathered():
    scheduler, early, late = Scheduler(), slot("early"), slot("late")
    scheduler.enter(early, 0)
    assert scheduler.gathered() == []
    scheduler.done(scheduler.next_due(0))
    scheduler.resume(late, 15)  # due at 20, and the other one at 10
    assert scheduler.gathered() == []


@pytest.mark.parametrize("change", ["enter", "resume", "leave", "change", "rekey", "next_due"])
def test_whatever_becomes_of_a_slot_parts_all_groups(change):
    a, b, other = slot("a"), slot("b"), slot("other")
    scheduler = grouped(a, b)
    given = {
        "enter": (other, 3), "resume": (other, 3), "leave": (a,), "change": (a, 20, 3), "rekey": (b, (0, 0, "b")),
        "next_due": (3,),
    }  # fmt: skip
    getattr(scheduler, change)(*given[change])
    assert scheduler.groups == []
    assert scheduler.next_due(10) is (b if change in ("leave", "change") else a)


def test_a_group_that_stops_leaves_each_slot_where_it_stands():  # law 2
    a, b, c = slot("a"), slot("b"), slot("c")
    scheduler = grouped(a, b, c)
    assert scheduler.part_at(1) is b
    assert (a.release, b.release, c.release) == (20, 10, 10)
    scheduler.done(b)
    assert scheduler.next_due(10) is c
