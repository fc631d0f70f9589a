"""Blows fall the same every time, and what came of them is judged."""

import signal
from dataclasses import replace

import pytest

from kit.faults.blows import Aftermath, Blow, Kind, Stage, blows

KILLS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
WELL = Aftermath(
    Stage.RUN,
    Blow(Kind.UNIT, signal.SIGKILL, 0.5),
    has_hit=True,
    code=1,
    ended_s=2.9,
    had_interrupt=False,
    told_s=0.9,
    silence_ns=90_000_000,
    left=[],
    unreadable="",
)


def test_blows_are_the_same_every_time():
    first, second = (list(blows(Stage.RUN, Kind.UNIT, 4, KILLS, seed=3)) for _ in range(2))
    assert first == second
    assert first != list(blows(Stage.RUN, Kind.UNIT, 4, KILLS, seed=4))


def test_what_ends_in_time_and_leaves_nothing_is_well():
    assert WELL.faults() == []
    assert replace(WELL, told_s=2.9, had_interrupt=True).faults() == []


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ({"left": ["a process"]}, "left behind: a process"),
        ({"output": ["Traceback (most recent call last):"]}, "a traceback"),
        ({"ended_s": 3.1}, "ended after 3.1 s"),
        ({"code": None}, "ended after 2.9 s"),
        ({"told_s": 1.1}, "told after 1.10 s"),
        ({"silence_ns": 101_000_000}, "a drive went on for 101 ms"),
        ({"unreadable": "why"}, "unreadable recording: why"),
    ],
)
def test_whatever_is_not_as_it_has_to_be_is_a_fault(change, fault):
    assert replace(WELL, **change).faults() == [fault]


def test_a_busy_machine_may_take_longer_but_no_drive():
    late = replace(WELL, ended_s=5.0, told_s=1.9, silence_ns=101_000_000)
    assert late.faults(patience=2.0) == ["a drive went on for 101 ms"]
