"""An alarm clock that can be waited for."""

import select
from time import monotonic

import pytest

from onika.runtime.alarm import Alarm


@pytest.fixture
def alarm():
    made = Alarm()
    yield made
    made.close()


def rings(alarm, within_s=0.0):
    return bool(select.select([alarm], [], [], within_s)[0])


def test_it_rings_when_the_time_is_over_and_not_before(alarm):
    began = monotonic()
    alarm.set(20_000_000)
    assert not rings(alarm)
    assert rings(alarm, 5.0)
    assert monotonic() - began >= 0.02


def test_it_can_be_stopped_before_and_after_it_rang(alarm):
    alarm.set(1)
    assert rings(alarm, 5.0)
    alarm.stop()
    assert not rings(alarm)
    alarm.set(3600 * 1_000_000_000)
    alarm.stop()
    assert not rings(alarm)


def test_a_time_in_the_past_rings_at_once(alarm):
    alarm.set(-5)
    assert rings(alarm, 5.0)


def test_another_time_takes_the_place_of_the_first(alarm):
    alarm.set(3600 * 1_000_000_000)
    alarm.set(1000)
    assert rings(alarm, 5.0)
