"""The transfer of one task by itself: what it asks of its channels, with time handed in (law 33)."""

from math import inf
from types import MappingProxyType, SimpleNamespace

import numpy as np
import pytest

from onika.module import InVar
from onika.ring.slots import Ring
from onika.runtime.transfer.bumpless_transfer import WATCHED_NS, BumplessTransfer, bumpless_channels, limit_of
from onika.words.reason import NOTHING, Reason

MS = 1_000_000


class Servo:
    """A module with a port whose name is not that of its attribute, and a parameter."""

    declared_ports = MappingProxyType({"torque": SimpleNamespace(name="TAU_MAX"), "SHARE": SimpleNamespace(name="")})

    torque = (10, 20)
    SHARE = 0.5

    def held(self, port):
        return f"what holds {port}"


class Channel:
    """Notes what it is asked; `blends` says for how many cycles it blends, `seen` what it saw."""

    def __init__(self, svar="TAU", step=0.25, blends=0, is_near=True, seen=None):
        self.svar, self.port, self.step = svar, f"port of {svar}", step
        self.blends, self.is_near, self.seen = blends, is_near, seen
        self.calls = []

    def keep(self):
        self.calls.append("keep")

    def allow(self, limit):
        self.calls.append(("allow", float(limit)))

    def change_rate(self, share):
        self.calls.append(("rate", share))

    def come_from(self, held):
        self.calls.append(held)
        return self.is_near

    def pass_on(self, now, most, is_bounded):
        self.calls.append((now, most, is_bounded))
        self.blends -= 1
        return self.blends >= 0

    def take(self, subsystem, task):
        self.calls.append(("take", subsystem, task))
        return self.seen

    def objection(self, value, most, task):
        return Reason.plain(f"{self.svar} {value} {most} {task}")


def transfer_of(*channels, period_ns=50 * MS):
    """A transfer whose blends take two cycles at most."""
    return BumplessTransfer("s", "arm", channels, period_ns)


@pytest.mark.parametrize(
    ("step", "limit"),
    [
        (2, [2.0]),
        ("SHARE", [0.5]),
        ("TAU_MAX", [10.0, 20.0]),
        (("TAU_MAX", 0.1), [1.0, 2.0]),
        (("TAU_MAX", "SHARE", 2), [10.0, 20.0]),
    ],
)
def test_a_limit_is_a_product_of_numbers_and_of_ports_by_their_names(step, limit):  # R-X04
    given = limit_of(Servo(), step)
    assert np.ravel(given).tolist() == pytest.approx(limit)
    assert np.asarray(given).dtype == np.float64
    assert limit_of(Servo(), None) is None


@pytest.mark.parametrize(("least", "said"), [(0.0, "0."), (-0.5, "-10."), (float("nan"), "nan")])
def test_a_limit_that_lets_nothing_through_is_refused_if_only_of_one_element(least, said):  # R-X04
    module = Servo()
    module.SHARE = np.array([1.0, least])
    with pytest.raises(ValueError, match="TAU_MAX") as refused:
        limit_of(module, ("TAU_MAX", "SHARE"))
    reason = refused.value.args[0]
    assert (reason.key, reason.args["product"]) == ("runtime.step_not_positive", "TAU_MAX * SHARE")
    assert said in reason.args["limit"]


def test_for_fifty_milliseconds_a_reconfiguration_is_watched():  # R-X04
    assert WATCHED_NS == 50 * MS


def test_who_has_told_nobody_whom_to_tell_tells_nobody():
    transfer = transfer_of(Channel(seen="a step"))
    assert transfer.is_open is False
    transfer.close()
    assert transfer.is_open is False


def test_what_was_seen_is_told_and_nothing_else():  # R-X04
    blind, seeing = Channel(), Channel(seen="a step")
    transfer, told = transfer_of(blind, seeing), []
    transfer.tell = told.append
    transfer.close()
    assert told == ["a step"]
    assert blind.calls == seeing.calls == [("take", "s", "arm")]


@pytest.mark.parametrize(
    ("watched", "bounded"),
    [
        ([True, False, False, False, False], [True, True, True, False, False]),
        ([False, False, False, False], [True, True, False, False]),
        ([True, False, True, False, False, False], [True, True, True, True, True, False]),
    ],
)
def test_a_course_is_bounded_while_it_is_watched_and_for_one_blend_more(watched, bounded):  # R-X04
    channel = Channel(blends=99)
    transfer = transfer_of(channel)
    for now, is_watched in enumerate(watched):
        transfer.pass_on(now, is_watched)
        assert transfer.is_open is True
    assert channel.calls == [(now, 2, is_bounded) for now, is_bounded in enumerate(bounded)]


def test_it_is_closed_when_nobody_watches_and_no_channel_blends():  # R-X04
    first, last = Channel(blends=2), Channel()
    transfer = transfer_of(first, last)
    states = []
    for now, is_watched in enumerate([True, False, False]):
        transfer.pass_on(now, is_watched)
        states.append(transfer.is_open)
    assert states == [True, True, False]


@pytest.mark.parametrize(("period_ns", "most"), [(2 * MS, 50), (60 * MS, 1), (100 * MS, 1), (200 * MS, 1)])
def test_a_blend_has_as_many_cycles_as_fit_and_one_at_least(period_ns, most):  # R-X04
    channel = Channel()
    transfer = transfer_of(channel, period_ns=period_ns)
    transfer.pass_on(7, True)
    assert channel.calls == [(7, most, True)]
    assert transfer.objection("TAU", 3).text == f"TAU 3 {most} arm"


def test_an_objection_comes_from_the_channel_of_the_variable():  # R-X04
    transfer = transfer_of(Channel("Q"), Channel("TAU"))
    assert transfer.objection("TAU", 3).text == "TAU 3 2 arm"
    assert transfer.objection("X", 3) == NOTHING


def test_at_another_rate_limits_and_blends_change_with_it():  # R-X04
    channel = Channel(step=("SHARE", 2))
    transfer = transfer_of(channel, period_ns=20 * MS)
    transfer.change_rate(Servo(), 5 * MS)
    assert channel.calls == [("allow", 1.0), ("rate", 4.0)]
    assert transfer.objection("TAU", 3).text == "TAU 3 20 arm"
    transfer.change_rate(Servo(), 10 * MS)
    assert channel.calls[-1] == ("rate", 0.5)


@pytest.mark.parametrize("near", [(True, True), (True, False), (False, True), (False, False)])
def test_after_a_hold_it_is_near_if_every_channel_is(near):  # R-X04
    channels = [Channel(f"T{number}", is_near=is_near) for number, is_near in enumerate(near)]
    assert transfer_of(*channels).come_from_hold(Servo()) is all(near)
    assert [channel.calls for channel in channels] == [["what holds port of T0"], ["what holds port of T1"]]


def test_every_channel_keeps_what_was_passed_on():  # R-X04
    channel = Channel()
    transfer_of(channel).keep()
    assert channel.calls == ["keep"]


def test_what_may_step_as_it_likes_is_not_watched():  # R-X04
    view = memoryview(bytearray(Ring.footprint(16)))
    steps = {"A": None, "B": inf, "C": 1.0, "D": "MIXED"}
    read = [
        (port, InVar("double[2]", step=step), f"{port}_REF", np.zeros(2), Ring(view, 0, 16))
        for port, step in steps.items()
    ]
    module = Servo()
    module.MIXED = np.array([inf, 1.0])
    channels = bumpless_channels(module, SimpleNamespace(read_each_cycle=read))
    assert [bool(channel.objection(np.array([0.0, 9.0]), 2)) for channel in channels] == [False, True, True]
    assert [(channel.port, channel.svar) for channel in channels] == [("A", "A_REF"), ("C", "C_REF"), ("D", "D_REF")]
