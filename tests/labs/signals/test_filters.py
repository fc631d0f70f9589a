"""Filters of joint values: low-pass, notch, median, limit of speed."""

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "signals" / "module"
PORTS = {"lowpass": ("Y", "Z"), "median": ("Y", "Z"), "ratelimit": ("Y", "Z"), "notch": ("TAU_IN", "TAU_OUT")}
NAN = float("nan")


def bench_of(name, value=(0.0, 0.0), hz=500, **local):
    bench = Bench(MODULES / f"{name}.py", frequency=hz, constants={"NDOF": 2}, local=local).init()
    bench[PORTS[name][0]] = value
    return bench.on()


def course(name, values, **local):
    """What comes out for these pairs, cycle by cycle."""
    reads, writes = PORTS[name]
    bench = bench_of(name, values[0], **local)
    rows = []
    for value in values:
        bench[reads] = value
        rows.append(bench.cycle()[writes].copy())
    return np.array(rows)


def sine(frequency, seconds=4.0, hz=500):
    return np.outer(np.sin(2 * np.pi * frequency * np.arange(round(seconds * hz)) / hz), [1.0, -2.0])


def height(passed):
    """That of sines, however they are sampled."""
    return np.sqrt(2 * np.mean(passed**2, axis=0))


@pytest.mark.parametrize("name", PORTS)
def test_a_filter_comes_on_with_what_comes_in_and_leaves_it_where_it_stays(name):  # R-K05
    assert course(name, [(0.25, -3.0)] * 20) == pytest.approx(np.array([(0.25, -3.0)] * 20))
    assert bench_of(name, (0.25, -3.0))[PORTS[name][1]].tolist() == [0.25, -3.0]


@pytest.mark.parametrize("name", PORTS)
def test_what_is_no_number_never_comes_out_of_a_filter(name):  # R-K05
    values = [(NAN, 1.0), (0.5, float("inf")), (NAN, NAN), (0.5, 1.0)] * 10
    passed = course(name, [(0.5, 1.0), *values])
    assert passed == pytest.approx(np.array([(0.5, 1.0)] * 41))


def test_a_low_pass_leaves_slow_things_alone_and_takes_quick_ones_away():  # R-K05
    for frequency, share in ((1.0, 1.0), (20.0, 0.5**0.5), (150.0, 0.01)):
        passed = course("lowpass", sine(frequency), CUTOFF=20)[1000:]
        assert height(passed) == pytest.approx([share, 2 * share], abs=0.02)


def test_a_notch_takes_away_its_middle_only():  # R-K05
    for frequency, share in ((5.0, 1.0), (25.0, 0.0), (100.0, 1.0)):
        passed = course("notch", sine(frequency), MIDDLE=25, WIDTH=5)[1500:]
        assert height(passed) == pytest.approx([share, 2 * share], abs=0.02)


@pytest.mark.parametrize(("name", "local"), [("lowpass", {"CUTOFF": 50}), ("notch", {"MIDDLE": 50})])
def test_a_filter_that_its_rate_cannot_carry_stays_off(name, local):  # R-A04
    bench = bench_of(name, hz=100, **local)
    assert bench.state is not State.ON
    assert "below 50 Hz, half of the rate, found 50 Hz" in bench.why


def test_a_median_takes_spikes_out_and_leaves_edges_sharp():  # R-K05
    values = np.zeros((60, 2))
    values[30:] = 1.0
    spiked = values.copy()
    spiked[[10, 11, 20, 45]] = 100.0
    passed = course("median", spiked, WINDOW=5)
    assert passed == pytest.approx(np.roll(values, 2, axis=0) * (np.arange(60) >= 2)[:, None])


def test_a_window_of_one_value_passes_everything():
    assert course("median", sine(3.0, 0.2), WINDOW=1) == pytest.approx(sine(3.0, 0.2))


def test_what_follows_is_never_faster_than_it_may_and_says_how_fast_it_is():  # R-K05
    bench = bench_of("ratelimit", hz=100, FASTEST=0.5)
    bench["Y"] = [1.0, -0.1]
    places, speeds = [], []
    for _ in range(250):
        bench.cycle()
        places.append(bench["Z"].copy())
        speeds.append(bench["Z^"].copy())
    steps = np.diff(places, axis=0, prepend=np.zeros((1, 2)))
    assert steps * 100 == pytest.approx(np.array(speeds), abs=1e-9)
    assert np.abs(speeds).max() == pytest.approx(0.5)
    assert places[19] == pytest.approx([0.1, -0.1])
    assert places[-1] == pytest.approx([1.0, -0.1])
