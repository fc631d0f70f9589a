"""An expert system as a task: what is wrong with an arm follows from rules, with reasons and certainties."""

import pytest

from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULE = shipped() / "control" / "module" / "diagnosis.py"
CONSTANTS = {"NDOF": 2, "TAUMAX": [10.0, 10.0]}


def bench_of(*rules, stop=2.0, lasting=0.1):
    local = {f"RULE{number}": rule for number, rule in enumerate(rules, 1)}
    return Bench(MODULE, frequency=100, constants=CONSTANTS, local={**local, "STOP": stop, "LASTING": lasting}).init()


def seen(bench, reference, measured, torque=(0.0, 0.0)):
    """What it concludes at the next cycle."""
    bench["Q_REF"], bench["Q_MEZ"], bench["TAU_REF"] = reference, measured, torque
    bench.cycle()
    return bench["CONCLUSION"], pytest.approx(bench["CERTAINTY"])


def begun(*rules, **limits):
    bench = bench_of(*rules, **limits)
    bench["Q_REF"] = bench["Q_MEZ"] = bench["TAU_REF"] = [0.0, 0.0]
    return bench.on()


def test_a_rule_is_as_certain_as_it_says_where_its_conditions_hold():  # R-K09
    bench = begun("away > 0.1 and effort > 0.5 then blocked 0.8")
    assert seen(bench, [0.2, 0.0], [0.0, 0.0], [4.0, 9.0]) == ("", 0.0)
    assert seen(bench, [0.2, 0.0], [0.0, 0.0], [6.0, 0.0]) == ("blocked, because away > 0.1 and effort > 0.5", 0.8)


def test_conclusions_are_conditions_of_others_in_whatever_order_they_stand():  # R-K09
    bench = begun("stands and effort > 0.5 then blocked 0.5", "away > 0.1 then stands 0.8")
    assert seen(bench, [0.2, 0.0], [0.0, 0.0], [6.0, 0.0]) == ("blocked, because stands and effort > 0.5", 0.4)


def test_two_reasons_make_a_conclusion_more_certain():  # R-K09
    bench = begun("away > 0.1 then wrong 0.5", "effort > 0.5 then wrong 0.5")
    assert seen(bench, [0.2, 0.0], [0.0, 0.0], [6.0, 0.0]) == ("wrong, because away > 0.1; effort > 0.5", 0.75)


def test_the_most_certain_conclusion_is_told():  # R-K09
    bench = begun("away > 0.1 then this 0.5", "away > 0.1 then that 0.6")
    assert seen(bench, [0.2, 0.0], [0.0, 0.0]) == ("that, because away > 0.1", 0.6)


def test_speeds_are_those_of_the_joint_that_is_farthest_away():  # R-K09
    bench = begun("speed > 0.5 and wanted > 5 then fast")
    seen(bench, [0.0, 0.0], [0.0, 0.0])
    assert seen(bench, [0.0, 0.1], [0.0, 0.01])[0] == "fast, because speed > 0.5 and wanted > 5"
    assert seen(bench, [0.0, 0.1], [0.0, 0.01])[0] == ""


def test_what_is_certain_for_long_enough_stops_the_run():  # R-K09
    bench = begun("away > 0.1 then wrong 0.9", stop=0.8, lasting=0.03)
    seen(bench, [0.2, 0.0], [0.0, 0.0])
    seen(bench, [0.2, 0.0], [0.0, 0.0])
    assert bench.failed is None
    seen(bench, [0.2, 0.0], [0.0, 0.0])
    assert bench.failed.text == "ModuleError: wrong, because away > 0.1 (certainty 0.90)"


@pytest.mark.parametrize(
    "rule",
    ["away > 0.1", "away then wrong", "away > then wrong", "stands > 1 then wrong", "away > 1 then wrong 2",
     "away > 1 then 7", "away > 1 then speed", "away > 1 then wrong much"],
)  # fmt: skip
def test_what_is_no_rule_is_told(rule):  # R-K09, R-B07
    assert "expected a rule as in" in bench_of(rule).failed.text


def test_rules_that_follow_from_themselves_are_told():  # R-K09
    assert "found a, b" in bench_of("a then b", "b then a").failed.text
    assert "concludes nothing_else, found none" in bench_of("nothing_else then b").failed.text
