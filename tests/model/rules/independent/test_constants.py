"""The order of constants and the exchange of tasks in a living subsystem: ours and the naive reading agree."""

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.rules.order import Ports, constant_order
from onika.model.rules.reconfiguration import PlacedTask, TaskExchange, difference, exchange
from onika.model.task import Task

from . import constants as naive
from .drawn import libraries, made
from .tasks import device

Tasks = tuple[Task, ...]


def orders_agree(tasks: Tasks) -> None:
    order, cycles = constant_order([Ports.of(task) for task in tasks])
    assert naive.is_in_order(order, tasks)
    assert {frozenset(cycle) for cycle in cycles} == naive.rings(tasks)


def placed(task: Task) -> PlacedTask:
    return PlacedTask(Ports.of(task), task.module, next(iter(sorted(device(task))), None))


def ours(living: Tasks, kill: set[str], new: Tasks) -> TaskExchange:
    return exchange([placed(task) for task in living], kill, [placed(task) for task in new])


def exchanges_agree(living: Tasks, kill: set[str], new: Tasks) -> None:
    """`new` takes no name that stays (A06)."""
    new = tuple(task for task in new if task.name in kill or task.name not in {item.name for item in living})
    result = ours(living, kill, new)
    after = [*(task for task in living if task.name not in kill), *new]
    assert set(result.keep) == naive.kept(living, kill)
    assert set(result.kill) == {task.name for task in living if task.name in kill}
    must = naive.killed_first(living, kill, new)
    assert must <= set(result.kill_first) <= must | naive.broken_into(living, kill, new)
    assert set(result.spawn) == {task.name for task in new}
    waits = naive.waits_for(after)
    if not naive.rings(after):  # else the change is refused (law 10)
        for each in (result.spawn, result.reinit):
            assert not any(later in waits[item] for at, item in enumerate(each) for later in each[at:])
        assert set(result.reinit) == naive.reinitialised(living, kill, new)


@given(st.booleans().flatmap(lambda sparse: libraries(7, sparse=sparse)))
@settings(max_examples=examples(100), deadline=None)
def test_any_tasks_are_spawned_after_those_they_wait_for(tasks: Tasks) -> None:
    orders_agree(tasks)  # law 10


@given(libraries(6, sparse=True), st.sets(st.sampled_from("pqrstuvw"), max_size=4), libraries(5, sparse=True))
@settings(max_examples=examples(150), deadline=None)
def test_any_exchange_keeps_kills_spawns_and_reinitialises_the_same(living: Tasks, kill: set[str], new: Tasks) -> None:
    exchanges_agree(living, kill, new)  # R-A13, reading 14


@given(libraries(4), libraries(4))
@settings(max_examples=examples(50), deadline=None)
def test_a_switch_is_the_difference_of_two_sets(before: Tasks, after: Tasks) -> None:
    on, wanted = [task.name for task in before], [task.name for task in after]  # R-A13, §5.3.4
    change = difference(on, wanted)
    assert set(change.off) == set(on) - set(wanted)
    assert set(change.keep) == set(on) & set(wanted)
    assert set(change.on) == set(wanted) - set(on)


def test_who_came_with_the_exchange_learns_what_a_reinitialised_task_says_anew() -> None:
    source = made("source", {}, {"A": "CONST"})  # R-A13: at second hand
    relay = made("relay", {"A": "CONST"}, {"B": "CONST"})
    newer = made("newer", {}, {"A": "CONST"})
    reader = made("reader", {"B": "CONST"}, {})
    assert ours((source, relay), {"source"}, (newer, reader)).reinit == ("relay", "reader")


def test_who_came_with_the_exchange_is_initialised_once_where_nothing_changes_behind_it() -> None:
    source = made("source", {}, {"A": "CONST"})  # R-A13
    newer, reader = made("newer", {}, {"A": "CONST"}), made("reader", {"A": "CONST"}, {})
    assert ours((source,), {"source"}, (reader, newer)).reinit == ()


@pytest.mark.slow
@given(libraries(7, sparse=True), st.sets(st.sampled_from("pqrstuvw"), max_size=5), libraries(6, sparse=True))
@settings(max_examples=examples(3000), deadline=None)
def test_thousands_of_exchanges_are_judged_alike(living: Tasks, kill: set[str], new: Tasks) -> None:
    orders_agree(living)  # law 10
    exchanges_agree(living, kill, new)  # R-A13, reading 14
