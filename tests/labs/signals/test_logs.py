"""What is written down of a signal: rows in a file, and figures."""

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "signals" / "module"


def bench_of(name, **local):
    bench = Bench(MODULES / f"{name}.py", frequency=50, constants={"NDOF": 2}, local=local).init()
    bench["Y"] = [0.0, 0.0]
    return bench.on()


def logged(bench, count):
    for k in range(count):
        bench["Y"] = [k / 8, -k]
        bench.cycle()
    return bench


def test_rows_are_written_when_the_task_goes_off_and_not_before(tmp_path):  # R-K05
    file = tmp_path / "rows.csv"
    bench = logged(bench_of("csv_log", FILE=str(file)), 3)
    assert not file.exists() and bench.get("rows") == 3
    bench.off()
    assert file.read_text().splitlines() == ["t,y1,y2", "0,0,0", "0.02,0.125,-1", "0.04,0.25,-2"]
    assert [path.name for path in tmp_path.iterdir()] == ["rows.csv"]
    logged(bench.on(), 1).kill()
    assert len(file.read_text().splitlines()) == 2


def test_more_rows_than_are_kept_are_told_and_those_that_are_kept_are_written(tmp_path):
    file = tmp_path / "rows.csv"
    bench = logged(bench_of("csv_log", FILE=str(file), ROWS=2000), 2000)
    assert bench.cycle().state is State.OFF
    assert "2000 rows are kept" in bench.warnings[0]
    table = np.loadtxt(file, delimiter=",", skiprows=1)
    assert table[:, 0] == pytest.approx(np.arange(2000) * 0.02)
    assert table[:, 2].tolist() == [-k for k in range(2000)]


def test_without_a_file_it_says_so_and_goes_off():
    bench = bench_of("csv_log").cycle()
    assert (bench.state, bench.cls.passive) == (State.OFF, True)
    assert "FILE names no file" in bench.warnings[0]


def test_a_file_that_cannot_be_written_is_told_and_harms_nothing(tmp_path):
    bench = logged(bench_of("csv_log", FILE=str(tmp_path / "nowhere" / "rows.csv")), 2).off()
    assert bench.state is State.OFF
    assert "cannot be written: No such file or directory" in bench.warnings[0]


def figures(values, **local):
    bench = bench_of("figures", ELEMENT=1, **local)
    for value in values:
        bench["Y"] = [0.0, value]
        bench.cycle()
    return bench["FIGURES"]


def test_figures_of_a_sine_are_those_that_one_knows():  # R-K05
    sine = 0.5 + np.sin(2 * np.pi * np.arange(500) / 100)
    expected = [-0.5, 1.5, 0.5, np.sqrt(0.25 + 0.5), 0.5 + np.cos(np.pi * 0.01)]
    assert figures(sine, SPAN=4) == pytest.approx(expected, abs=2e-3)  # of 200 values


def test_figures_forget_what_is_longer_ago_than_their_span():
    assert figures([9.0] * 100 + [1.0] * 50, SPAN=1) == pytest.approx([1.0] * 5)
    assert figures([9.0, 1.0], SPAN=1)[:3] == pytest.approx([1.0, 9.0, 5.0])


def test_figures_of_an_element_that_is_not_there_are_refused():
    bench = Bench(MODULES / "figures.py", frequency=50, constants={"NDOF": 2}, local={"ELEMENT": 2}).init()
    assert bench.state is State.ERROR
    assert "expected 0..1, found 2" in bench.why
