"""The demonstration of §4.5.2 by two PUMAs: one puts the rotor into its housing, the other the lid onto both."""

import json
from pathlib import Path

import pytest

import onika
from onika.cli import main

pytestmark = pytest.mark.site

PRESSED = """
wait began {flow} {action}
wait {after}
touch motor_pair panic_{side} 1
wait stopped {flow}
touch motor_pair panic_{side} 0
wait 0.5
clear {flow}
wait done {flow} {action}
"""
SHIPPED = Path(onika.__file__).parent / "labs" / "motor" / "appl" / "motor_together.appl"
KINEMATIC = ("--redirect", "motor_left=motor_left_kin", "--redirect", "motor_right=motor_right_kin")


def assembled(capsys, *words, application="motor_together"):
    code = main(["run", application, "--virtual", "--json", "--expect", "LAMP == 1", *words])
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    return code, lines, lines[-1]


def test_both_arms_meet_and_rotor_and_lid_sit_where_they_belong(capsys):  # R-K06, R-E04, R-K08
    code, lines, result = assembled(capsys)
    assert (code, result["state"], result["notes"], result["actions_done"]) == (0, "completed", [], 24)
    assert [line["tag"] for line in lines if line["event"] == "met"] == ["rotor_is_in", "motor_is_whole"]
    said = [line["text"]["args"] for line in lines if line.get("task") == "cguard" and "args" in line.get("text", {})]
    assert [(round(args["z"]), 18 < args["force"] < 30) for args in said if "force" in args] == [(-29, True)]


def test_where_the_lid_is_let_go_beside_the_rotor_the_lamp_stays_dark(capsys, tmp_path):  # R-K06
    beside = tmp_path / "beside.appl"
    text = SHIPPED.read_text()
    assert text.count(" 0.7 0.0 -0.27\n") == text.count(" 0.7 0.0 -0.2925\n") == 1
    beside.write_text(
        text.replace(" 0.7 0.0 -0.27\n", " 0.712 0.0 -0.27\n").replace(" 0.7 0.0 -0.2925\n", " 0.712 0.0 -0.2925\n")
    )
    code, _, result = assembled(capsys, application=str(beside))
    assert (code, result["state"], result["values"]) == (1, "completed", {"LAMP": 0})


@pytest.mark.parametrize(
    ("side", "flow", "action", "after"),
    [
        ("left", "flow0", 6, 1),  # with the rotor in the air
        ("right", "flow1", 6, 1),  # with the lid in the air
        ("right", "flow1", 8, 0.3),  # while it goes down until it meets something
    ],
)
def test_the_panic_button_in_the_middle_is_cleared_and_the_motor_completed(
    capsys, tmp_path, side, flow, action, after
):  # R-K06, R-E08
    script = tmp_path / "panic"
    script.write_text(PRESSED.format(side=side, flow=flow, action=action, after=after))
    code, lines, result = assembled(capsys, "--script", str(script))
    assert (code, result["state"], result["actions_done"]) == (0, "completed", 24)
    drives = [line["state"] for line in lines if line.get("device") == f"motor_pair:arm_{side}"]
    pressed = drives.index("PRESSED")
    assert drives[pressed - 1 : pressed + 4] == ["DRIVEN", "PRESSED", "TRIPPED", "HELD", "DRIVEN"]


def test_it_is_redirected_to_the_simulator_and_back(capsys):  # R-K06, R-K03, R-E09
    code, lines, result = assembled(capsys, *KINEMATIC)
    assert (code, result["state"], result["actions_done"]) == (0, "completed", 24)
    assert {line["device"] for line in lines if ":arm_" in line.get("device", "")} == {
        "motor_pair:arm_left_kin",
        "motor_pair:arm_right_kin",
    }
    code, lines, result = assembled(capsys)
    assert (code, result["state"], result["actions_done"]) == (0, "completed", 24)
    assert {line["device"] for line in lines if ":arm_" in line.get("device", "")} == {
        "motor_pair:arm_left",
        "motor_pair:arm_right",
    }


BETWEEN = """
begin motor_together
break flow0 6
wait flow0 paused within 60
abort
wait 0.1
begin motor_together motor_left=motor_left_kin motor_right=motor_right_kin flow0@7 flow1@6
break flow0 8
wait flow0 paused within 60
abort
wait 0.1
begin motor_together flow0@9 flow1@6
wait run
wait flow0/LAMP == 1 within 1
"""


def test_a_work_that_has_begun_goes_on_at_the_simulator_and_back_with_the_rotor_in_the_hand(
    capsys, tmp_path
):  # R-K06, R-E09
    script = tmp_path / "between"
    script.write_text(BETWEEN)
    assert main(["runtime", "--virtual", "--script", str(script), "--no-console"]) == 0
    output = capsys.readouterr().out
    assert (output.count("run aborted"), output.count("run completed")) == (2, 1)
    assert output.count("rotor_is_in, 0 us apart") == 1
