"""Conditions, counts and times of signals, and the choices that follow from them."""

import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "signals" / "module"


def bench_of(name, **local):
    return Bench(MODULES / f"{name}.py", frequency=100, local=local).init()


def end_of(bench):
    """Its return value: flow, loop."""
    return bench.finished.flow, bench.finished.loop


def events(name, pulses, line=""):
    """A bench that has seen an event go on and off: 1 is on."""
    bench = bench_of(name).on(line)
    for pulse in pulses:
        if bench.state is State.ON:
            bench["EVENT"] = pulse
            bench.cycle()
    return bench


def test_a_number_is_high_from_one_level_on_and_low_from_another_on():  # R-K05
    bench = bench_of("schmitt", LOW=-1, HIGH=2).on()
    seen = []
    for number in (0, 1.9, 2, 1.9, 0, -0.9, -1, 0, 1.9, float("nan"), 2.1):
        bench["SIGNAL"] = number
        seen.append(bench.cycle()["EVENT"])
    assert seen == [0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1]


def test_levels_that_stand_the_wrong_way_round_are_refused():
    bench = bench_of("schmitt", LOW=1, HIGH=1)
    assert bench.state is State.ERROR
    assert "expected LOW below HIGH, found 1 and 1" in bench.why


def test_each_rise_of_an_event_counts_once_and_the_last_one_ends_the_job():  # R-K05, R-B10
    bench = events("counter", [0, 1, 1, 0, 0, 5, 0, -1, 0, 1], "3")
    assert (bench["COUNT"], bench.cycles, end_of(bench)) == (3, 8, (0, False))


def test_what_happens_already_does_not_count_and_what_is_left_can_be_asked_for():  # R-A05
    bench = bench_of("counter")
    bench["EVENT"] = 1
    bench.on("2").cycle(3)
    assert bench.get("left") == 2
    assert bench_of("counter").on("0").state is State.ASKING


def test_a_stopwatch_tells_how_long_an_event_took_and_how_far_apart_two_are():  # R-K05
    bench = events("stopwatch", [0, 1, 1, 1, 0, 0, 0, 1, 1, 0, 0])
    assert (bench["LASTED"], bench["APART"]) == (pytest.approx(0.02), pytest.approx(0.06))
    first = events("stopwatch", [0, 1, 1, 1, 0, 0])
    assert (first["LASTED"], first["APART"]) == (pytest.approx(0.03), 0.0)


def test_an_event_of_which_nobody_knows_when_it_began_is_not_timed():
    bench = bench_of("stopwatch")
    bench["EVENT"] = 1
    bench.on().cycle(5)
    bench["EVENT"] = 0
    assert bench.cycle(5)["LASTED"] == 0.0


@pytest.mark.parametrize(("side", "numbers"), [("above", (0.2, 0.25, 0.26)), ("below", (0.3, 0.25, 0.24))])
def test_a_wait_ends_as_soon_as_the_number_is_beyond_the_level(side, numbers):  # R-B10, R-E05
    bench = bench_of("when", SIDE=side)
    for number in numbers:
        bench["SIGNAL"] = number
        bench = bench.on("0.25") if bench.state is State.OFF else bench
        bench.cycle()
    assert (end_of(bench), bench.cycles) == ((1, False), 3)


def test_a_wait_gives_up_when_its_patience_is_over():  # R-E05
    bench = bench_of("when", PATIENCE=0.3).on("1").cycle(1000)
    assert (end_of(bench), bench.cycles) == ((0, True), 30)


def test_a_side_that_is_none_is_refused():
    assert "expected above or below, found beside" in bench_of("when", SIDE="beside").why


@pytest.mark.parametrize(
    ("number", "flow"), [(-9.0, 0), (0.199, 0), (0.2, 1), (0.49, 1), (0.5, 2), (1e9, 2), (float("inf"), 2)]
)
def test_a_number_takes_the_flow_between_its_bounds(number, flow):  # R-K05, R-E05
    bench = bench_of("sorter", BOUNDS="0.2 0.5")
    bench["SIGNAL"] = number
    bench.on().cycle()
    assert end_of(bench) == (flow, flow == 0)


def test_what_is_no_number_takes_no_flow():
    bench = bench_of("sorter")
    bench["SIGNAL"] = float("nan")
    bench.on().cycle()
    assert (bench.state, bench.finished) == (State.ERROR, None)


@pytest.mark.parametrize("bounds", ["", "1 x", "2 1", "1 1"])
def test_bounds_that_do_not_rise_are_refused(bounds):
    assert "expected numbers that rise" in bench_of("sorter", BOUNDS=bounds).why


@pytest.mark.parametrize("flow", [0, 3])
def test_a_program_takes_the_flow_that_its_target_names(flow):  # R-B10
    bench = bench_of("choose").on(str(flow)).cycle()
    assert (end_of(bench), bench.cycles) == ((flow, False), 1)
    assert bench_of("choose").on("-1").state is State.ASKING
