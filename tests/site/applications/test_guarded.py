"""Motions that press with so much at most, with both arms, in virtual time: a box is met, the hand stays on it."""

import json
import math

import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from onika.cli import main
from onika.desk.plan.preparation import prepare
from onika.desk.run.forecast import Forecast
from onika.files import appl
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.words.fault import Place

ABOVE = {
    "": (-0.21463, -0.745079, 2.926112, 0.0, 0.96056, 1.356167),
    "_right": (-0.274507, -1.025077, 3.432307, 0.0, 0.734363, -1.845304),
}
"""The joints with which the hand of either arm is above the box with the waves, at x = 0.7 and y = 0."""
LIMIT = 20.0


def lowered(path, arm, height, *behind):
    """A program that goes above a box, and down to a height."""
    above = [job(f"jmove{arm}C", "Joint job"), joints("above", *ABOVE[arm], duration=3.0)]
    down = target("down", "Guarded object", f"0.0 0.0 -1.0 0.0 1.0 0.0 0.7 0.0 {height}", "1.0", str(LIMIT), "10.0")
    return Laboratory(path).application("lower", [*above, job(f"cguard{arm}C", "Guarded job"), down, *behind])


def carried_out(capsys, path, *expected):
    code = main(["run", str(path), "--virtual", "--json", *(f"--expect={wish}" for wish in expected)])
    return code, json.loads(capsys.readouterr().out.splitlines()[-1])


@pytest.mark.site
@pytest.mark.parametrize("arm", ["", "_right"])
def test_a_hand_that_meets_a_box_stays_on_it_and_presses_no_harder_than_its_target_says(capsys, tmp_path, arm):  # R-D25
    code, result = carried_out(capsys, lowered(tmp_path, arm, "-0.3"), "X_MEZ[2,3] > -0.298", "F_MEZ[2] > 1")
    assert (code, result["actions_done"]) == (0, 2)
    assert math.hypot(*result["values"]["F_MEZ"][:3]) < LIMIT


@pytest.mark.site
@pytest.mark.parametrize(("height", "flow"), [("-0.3", 1), ("-0.15", 0)])
def test_whether_something_was_met_is_what_a_choice_behind_it_goes_by(capsys, tmp_path, height, flow):  # R-D25, R-D10
    path = lowered(tmp_path, "", height, job("choose", "Complete application"))
    Laboratory(tmp_path).application("choose", [job("closegripC")], [job("opengripC")])
    code, result = carried_out(capsys, path, f"GRIP_MEZ[0] {'>' if flow else '<'} 0.07")
    assert (code, result["actions_done"]) == (0, 3)


@pytest.mark.site
def test_the_shipped_one_is_foreseen_without_alarm_and_the_same_motion_without_a_limit_is_told():  # R-E16, R-D25
    site = open_site([], {}, None)
    syntax, _ = site.syntax()
    path = shipped() / "boxes" / "appl" / "touch_down.appl"
    whole, _ = appl.read(path.read_text(), "touch_down", str(path), syntax)
    prepared = prepare(whole, Place("touch_down"), site, syntax)
    result = Forecast(prepared.plan, prepared.targets).carry_out()
    assert (str(result.cause), result.mishaps) == ("", [])
    result = Forecast(prepared.plan, ()).carry_out()
    assert [str(mishap.text) for mishap in result.mishaps] == ["the hand touches the box with the triangle"]


@pytest.mark.site
def test_a_hand_presses_on_a_box_with_the_force_of_its_target(capsys):  # R-B10, R-D25
    code = main(["run", "press_on_box", "--virtual", "--json", "--expect=F_MEZ[2] > 18", "--expect=F_MEZ[2] < 22"])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["state"]) == (0, "completed")
