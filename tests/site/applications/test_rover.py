"""A laboratory that drives: a rover in a hall (requirement K04)."""

import json

import pytest

from onika.cli import main

pytestmark = pytest.mark.site

THERE = [f"P_TRUE[0] {r}" for r in ("> 0.14", "< 0.26")] + [f"P_TRUE[1] {r}" for r in ("> -0.86", "< -0.74")]


def run(capsys, *words):
    code = main(["run", *words, "--virtual", "--json"])
    return code, json.loads(capsys.readouterr().out.splitlines()[-1])


@pytest.mark.slow  # a page of the guide does the same
def test_the_rover_drives_to_two_places_and_turns_back(capsys):  # R-K04
    turned = ("P_MEZ[2] > 3.1", "P_MEZ[2] < 3.2", "P_TRUE[2] > 3.0")
    expectations = [word for text in (*THERE, *turned) for word in ("--expect", text)]
    code, result = run(capsys, "rover_tour", *expectations)
    assert (code, result["state"], result["notes"]) == (0, "completed", [])
    assert result["runtime_s"] < 25


@pytest.mark.slow  # a page of the guide does the same
def test_without_forces_it_comes_there_exactly(capsys):  # R-K04, R-K03
    expectations = [word for text in THERE for word in ("--expect", text)]
    code, result = run(capsys, "rover_tour", "--redirect", "rover=rover_kin", *expectations)
    assert (code, result["state"]) == (0, "completed")


def test_it_drives_up_to_the_green_place_by_its_eye_the_same_each_time(capsys):  # R-K04, R-F05, R-X06
    facts = ["UV[0] > 157.5", "UV[0] < 161.5", "UV[1] > 153", "P_TRUE[0] > 0.5", "P_TRUE[1] > 0.2"]
    results = []
    for _ in range(2):
        words = ["run", "rover_green", "--virtual", "--json", *(f"--expect={fact}" for fact in facts)]
        code = main(words)
        results.append((code, json.loads(capsys.readouterr().out.splitlines()[-1])))
        if "cannot render" in str(results[-1]):
            pytest.skip("this machine cannot render")
    assert [(code, result["state"]) for code, result in results] == [(0, "completed")] * 2
    assert results[0][1]["hash"] == results[1][1]["hash"]
