import pytest

from onika.host.subsystems.load_forecast import ComingTask, LoadForecast
from onika.runtime.load import TaskLoad


def load(task, use, cycles=100, is_on=True):
    return TaskLoad("s0", task, is_on, 100.0, use * 1e4, use * 2e4, cycles)


def coming(task="new", digest="n", hz=100.0, rtpu="rt0"):
    return ComingTask(rtpu, "s0", task, digest, hz)


@pytest.fixture
def forecast():
    forecast = LoadForecast()
    forecast.hear("rt0", [(load("heavy", 0.6), "h")])
    forecast.hear("rt1", [(load("new", 0.5), "n")])
    return forecast


def test_who_would_take_a_unit_beyond_its_time_is_told_with_the_number(forecast):  # R-X13
    ((who, use, text),) = forecast.warnings([], [coming()])
    assert (who.task, round(use, 2)) == ("new", 1.1)
    assert "1.10" in str(text)
    assert "rt0" in str(text)


def test_who_goes_off_makes_room(forecast):  # R-X13
    assert forecast.warnings([("s0", "heavy")], [coming()]) == []


def test_a_higher_rate_of_a_task_that_is_on_is_judged_in_its_own_place(forecast):  # R-X13, R-A04
    assert forecast.warnings([], [coming("heavy", "h", hz=100.0)]) == []
    ((_, use, _),) = forecast.warnings([], [coming("heavy", "h", hz=200.0)])
    assert use == pytest.approx(1.2)


def test_those_who_come_together_are_added_up(forecast):  # R-X13
    forecast.hear("rt2", [(load("a", 0.3), "a")])
    few = [coming(f"n{number}", "a", rtpu="rt3") for number in range(4)]
    assert [who.task for who, _, _ in forecast.warnings([], few)] == ["n3"]


def test_what_was_never_measured_long_enough_is_not_held_against_it(forecast):
    forecast.hear("rt2", [(load("young", 5.0, cycles=3), "y")])
    assert forecast.warnings([], [coming("young", "y")]) == []
    assert forecast.warnings([], [coming("stranger", "s")]) == []
