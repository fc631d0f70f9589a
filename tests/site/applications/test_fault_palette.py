"""Faults to try, dropped in between an arm and all who read where it is: each one reaches an error (X14)."""

import json
import re

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.labs.varied_job import placed, varied
from onika.cli import main

pytestmark = pytest.mark.site

AT_THE_ARM = "SVARALIAS   Q_MEZ = Q_TRUE\n"
"""What the arm writes is called so; the fault writes Q_MEZ in its place, and servo, model and watch read that."""
AT_THE_WATCH = "SVARALIAS   Y = Q_MEZ", "SVARALIAS   Z = Q_SEEN"
"""The watch alone reads what the fault writes, as from an encoder of its own."""
CAUSES = {  # a late servo shakes the arm: whether it is too far or too fast first is the workcell's affair
    "delay": ("LATE 0.08", "from where it is to be|and can move at"),
    "noise": ("SIGMA 0.03", "and can move at"),
    "drop_out": ("SHARE 0.1", "and can move at"),
    "stuck": ("ELEMENT 1", "joint 2 is measured to stand still"),
    "lost_link": ("AFTER 0.4", "nothing measured has changed"),
}


def moved(capsys, path, writer, *dropped_in):
    """The result of a move by the tasks of the shipped job, of which one has this line more, and these tasks."""
    lab = Laboratory(path)
    varied(lab, "tryC", "jmoveC", dropped_in, {"puma": writer})
    goal = joints("aside", 0.7, -1.1, 1.2, 0.2, 0.3, 0.4, duration=2.0)
    program = lab.application("try_it", [job("tryC", "Joint job"), goal])
    code = main(["run", str(program), "--virtual", "--json"])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert result["exit"] == code
    return result


def test_an_arm_without_a_fault_follows_to_the_end(capsys, tmp_path):  # R-X14
    result = moved(capsys, tmp_path, "", placed("following", 250))
    assert (result["state"], result["notes"]) == ("completed", [])


def assert_stopped(result, sentence):
    """The watch stopped it, after the fault began and before the move was over."""
    assert (result["state"], result["actions_done"]) == ("aborted", 0)
    assert "following is in error" in result["cause"]["text"]
    assert re.search(sentence, result["cause"]["text"])
    assert 0.4 <= result["runtime_s"] < 2.5


@pytest.mark.parametrize("fault", CAUSES)
def test_a_fault_between_the_arm_and_all_its_readers_reaches_its_error(capsys, tmp_path, fault):  # R-X14
    local, sentence = CAUSES[fault]
    lines = dict.fromkeys((f"LOCAL       {local}", "LOCAL       AFTER 0.4"))
    result = moved(capsys, tmp_path, AT_THE_ARM, placed(fault, 500, *lines), placed("following", 250))
    assert_stopped(result, sentence)


def test_a_drift_of_a_second_encoder_reaches_its_error(capsys, tmp_path):  # R-X14
    drift = placed("slow_drift", 500, *AT_THE_WATCH, "LOCAL       RATE 0.5", "LOCAL       AFTER 0.4")
    watch = placed("following", 250, "SVARALIAS   Q_MEZ = Q_SEEN")
    assert_stopped(moved(capsys, tmp_path, "", drift, watch), "joint 1 is measured 0.1")


@pytest.mark.parametrize(
    ("fault", "conclusion"),
    [("delay", "wild"), ("noise", "wild"), ("stuck", "sensor_silent"), ("lost_link", "sensor_silent")],
)
def test_an_expert_system_says_which_fault_it_is(capsys, tmp_path, fault, conclusion):  # R-K09, R-X14
    lines = dict.fromkeys((f"LOCAL       {CAUSES[fault][0]}", "LOCAL       AFTER 0.4"))
    result = moved(capsys, tmp_path, AT_THE_ARM, placed(fault, 500, *lines), placed("diagnosis", 250))
    assert result["state"] == "aborted"
    assert f"{conclusion}, because" in result["cause"]["text"]


def test_an_arm_without_a_fault_is_found_well_by_the_expert_system(capsys, tmp_path):  # R-K09
    result = moved(capsys, tmp_path, "", placed("diagnosis", 250))
    assert (result["state"], result["notes"]) == ("completed", [])
