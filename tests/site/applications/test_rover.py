"""A laboratory that drives: a rover in a hall (requirement K04)."""

import json

import pytest

from onika.cli import main

pytestmark = pytest.mark.site

THERE = [f"P_TRUE[0] {r}" for r in ("> 0.14", "< 0.26")] + [f"P_TRUE[1] {r}" for r in ("> -0.86", "< -0.74")]


def run(capsys, *words):
    code = main(["run", *words, "--virtual", "--json"])
    return code, json.loads(capsys.readouterr().out.splitlines()[-1])


def test_the_rover_drives_to_two_places_and_turns_back(capsys):  # R-K04
    turned = ("P_MEZ[2] > 3.1", "P_MEZ[2] < 3.2", "P_TRUE[2] > 3.0")
    expectations = [word for text in (*THERE, *turned) for word in ("--expect", text)]
    code, result = run(capsys, "rover_tour", *expectations)
    assert (code, result["state"], result["notes"]) == (0, "completed", [])
    assert result["runtime_s"] < 25


def test_without_forces_it_comes_there_exactly(capsys):  # R-K04, R-K03
    expectations = [word for text in THERE for word in ("--expect", text)]
    code, result = run(capsys, "rover_tour", "--redirect", "rover=rover_kin", *expectations)
    assert (code, result["state"]) == (0, "completed")
