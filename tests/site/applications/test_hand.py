"""A laboratory of fingers: a hand turns a knob (requirement K04)."""

import json

import pytest

from onika.cli import main

pytestmark = pytest.mark.site


@pytest.mark.slow  # a page of the guide does the same
def test_the_hand_grasps_the_knob_and_turns_it_by_a_quarter_at_least(capsys):  # R-K04
    words = ["X_KNOB[0,0] < 0", "X_KNOB[1,0] > 0.5", "X_KNOB[2,2] > 0.999", "X_KNOB[2,3] < 0.155"]
    expectations = [word for text in words for word in ("--expect", text)]
    code = main(["run", "turn_knob", "--virtual", "--json", *expectations])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["state"], result["notes"], result["actions_done"]) == (0, "completed", [], 9)
