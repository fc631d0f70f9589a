from itertools import count

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from onika.engine.orders import Launch, Switch
from onika.host.execution.switch_dispatch import SwitchDispatch
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.ring.segment import Segment
from onika.runtime import news
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.words.reason import Reason

HOMES = {"a": "rt0", "b": "rt1", "c": "rt0", "d": "rt1", "e": "rt2"}


class Units:
    def __init__(self):
        self.sent = []

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def take(self):
        """What went out since: the unit, who goes off, who comes on."""
        taken, self.sent = self.sent, []
        return [(rtpu, order.off, tuple(launch.task for launch in order.on)) for rtpu, order in taken]


@pytest.fixture
def units():
    return Units()


@pytest.fixture
def board(units):
    shop = PlanBuilder()
    for name in HOMES:
        shop.task(name, f"from onika.module import Module\nclass {name.upper()}(Module):\n    trigger = True\n")
    prepared = prepare(shop.plan([action(*HOMES)]), (), ModuleFacts())
    subsystem = RunningSubsystem("flow0", Table(Segment.create("table", SIZE)), prepared.flows[0], HOMES)
    return SwitchDispatch(subsystem, units, count(1))


def switch(*on, off=(), rates=()):
    return Switch(0, tuple(off), tuple(Launch(name) for name in on), tuple(rates))


def test_neighbours_on_one_unit_come_on_together(board, units):  # law 6
    board.put(switch("a", "c", "b"), ())
    assert units.take() == [("rt0", (), ("a", "c"))]


def test_a_group_goes_out_when_the_whole_group_before_it_is_through(board, units):  # law 3, reading 14
    board.put(switch("a", "c", "b", "d", "e", "a"), ())
    assert units.take() == [("rt0", (), ("a", "c"))]
    board.settled("a")
    assert units.take() == []
    board.settled("c")
    assert units.take() == [("rt1", (), ("b", "d"))]
    board.settled("d")
    board.settled("b")
    assert units.take() == [("rt2", (), ("e",))]


def test_tasks_go_off_on_every_unit_before_any_comes_on(board, units):  # law 6
    board.put(switch("b", off=("a", "e")), ())
    assert units.take() == [("rt0", ("a",), ()), ("rt2", ("e",), ()), ("rt1", (), ("b",))]


def test_off_and_on_of_one_unit_are_one_command(board, units):  # law 6
    board.put(switch("c", off=("a",)), ())
    assert units.take() == [("rt0", ("a",), ("c",))]


def test_rates_reach_the_unit_of_their_task_even_where_nothing_goes_off(board, units):  # reading 13
    board.put(switch("a", rates=[("e", 5.0)]), ())
    sent = dict(units.sent)
    assert sent["rt2"].rates == (("e", 5.0),)
    assert [task.task for task in sent["rt0"].on] == ["a"]


def test_what_is_forgotten_is_said_with_the_first_group(board, units):  # law 3
    board.put(switch("a", "b"), ("X_REF",))
    board.settled("a")
    assert [order.forget for _, order in units.sent] == [("X_REF",), ()]


def test_a_second_switch_waits_for_the_first(board, units):  # law 6
    board.put(switch("a"), ())
    board.put(switch("b"), ())
    assert units.take() == [("rt0", (), ("a",))]
    board.settled("a")
    assert units.take() == [("rt1", (), ("b",))]


def test_one_command_that_can_begin_now_is_left_to_the_caller(board, units):  # R-E04
    rtpu, whole = board.launch_alone(switch("a", "c"), ())
    assert (rtpu, [launch.task for launch in whole.on]) == ("rt0", ["a", "c"])
    assert units.take() == []
    assert board.launch_alone(switch("e"), ()) is None  # it waits for the first
    assert units.take() == []
    for task in ("a", "c"):
        board.settled(task)
    assert units.take() == [("rt2", (), ("e",))]


def test_a_switch_on_several_units_is_never_left_to_the_caller(board, units):  # law 3
    assert board.launch_alone(switch("a", "b"), ()) is None
    assert units.take() == [("rt0", (), ("a",))]


@pytest.mark.parametrize(
    ("message", "is_late"),
    [
        (news.Changed("flow0", "a", "ON", 5, activation=1), True),
        (news.Changed("flow0", "a", "ON", 5, activation=2), False),
        (news.Changed("flow0", "a", "KILLED", 5, activation=1), False),
        (news.Failed("flow0", "a", "cycle", Reason.plain("no"), "", 0, "", 5, activation=1), False),
        (news.Warned("flow0", "a", Reason.plain("hot"), 5), False),
    ],
)
def test_news_of_an_earlier_activation_is_late_but_for_an_error_and_the_end(board, message, is_late):  # decision 4
    board.put(switch("a"), ())
    board.settled("a")
    board.put(switch("a"), ())
    assert board.is_late(message) is is_late


def test_after_a_kill_nothing_more_comes_on(board, units):  # R-E14
    board.put(switch("a", "b"), ())
    board.drop()
    units.take()
    board.settled("a")
    assert units.take() == []


def test_whoever_nobody_waits_for_changes_nothing(board, units):
    board.settled("a")
    board.put(switch("a", "b"), ())
    board.settled("e")
    assert units.take() == [("rt0", (), ("a",))]


def test_who_is_turned_off_does_not_come_on_later_either(board, units):  # R-E08
    board.put(switch("a", "b", "c"), ())
    units.take()
    board.turn_off("c")
    board.turn_off("a")
    assert units.take() == [("rt0", ("c",), ()), ("rt0", ("a",), ())]
    board.settled("a")
    assert units.take() == [("rt1", (), ("b",))]
    board.settled("b")
    assert units.take() == [("rt0", (), ())]  # nobody is left to come on
