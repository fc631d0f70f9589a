"""The comparison of benchmarks with what was kept: it alarms at 110 %, and its counts mind no load of the machine."""

import json
from pathlib import Path

import pytest

BENCH = Path(__file__).parents[2] / "tools" / "bench"


@pytest.fixture
def check(monkeypatch, tmp_path):
    monkeypatch.syspath_prepend(BENCH)
    import check

    monkeypatch.setattr(check, "KEPT", tmp_path / "kept.json")
    return check


def test_what_is_counted_is_the_same_again(check):
    from beside.counted import counts

    first, second = counts(), counts()
    assert first.keys() == second.keys()
    assert all(second[name] == pytest.approx(figure, rel=0.005) for name, figure in first.items())


def test_a_sweep_costs_less_than_half_of_the_same_one_by_one(check):
    from beside.counted import counts

    figures = counts()
    assert figures["a block of the loop, swept"] < figures["a block of the loop, one by one"] / 2


@pytest.mark.parametrize(("figure", "code"), [(109.0, 0), (110.0, 1), (50.0, 0)])
def test_at_110_percent_it_alarms(check, monkeypatch, capsys, figure, code):
    monkeypatch.setattr(check, "counts", lambda: {"a block": 100.0})
    assert check.main(["--keep"]) == 0
    monkeypatch.setattr(check, "counts", lambda: {"a block": figure})
    assert check.main([]) == code
    assert ("ABOVE" in capsys.readouterr().out) == bool(code)


def test_what_was_never_kept_is_new_and_no_fault(check, monkeypatch, capsys):
    monkeypatch.setattr(check, "counts", lambda: {"a block": 100.0})
    assert check.main([]) == 0
    assert capsys.readouterr().out.startswith("new")


def test_counts_of_another_python_are_kept_beside(check, monkeypatch):
    monkeypatch.setattr(check, "counts", lambda: {"a block": 100.0})
    check.KEPT.write_text(json.dumps({"counts of Python 2.7": {"a block": 1.0}}))
    assert check.main(["--keep"]) == 0
    assert len(json.loads(check.KEPT.read_text())) == 2
