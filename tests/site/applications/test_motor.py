"""The demonstration of §4.5.2: a small motor is assembled, also after the panic button; and by the simulator."""

import json

import pytest

from onika.cli import main

pytestmark = pytest.mark.site

PRESSED = """
wait began 6
wait 1
touch motor panic_bay 1
wait stopped
touch motor panic_bay 0
wait 0.5
clear
wait done 6
"""


def assembled(capsys, *words):
    code = main(["run", "assemble_motor", "--virtual", "--json", *words])
    return code, [json.loads(line) for line in capsys.readouterr().out.splitlines()]


@pytest.mark.slow  # the one below does the same, and more
def test_rotor_and_cap_come_to_where_they_belong_and_the_lamp_is_lit(capsys):  # R-K06
    code, lines = assembled(capsys, "--expect", "LAMP == 1")
    assert (code, lines[-1]["state"], lines[-1]["notes"], lines[-1]["actions_done"]) == (0, "completed", [], 17)


@pytest.mark.slow  # a page of the guide does the same
def test_the_panic_button_in_the_middle_is_cleared_and_the_motor_completed(capsys, tmp_path):  # R-K06, R-E08
    script = tmp_path / "panic"
    script.write_text(PRESSED)
    code, lines = assembled(capsys, "--script", str(script), "--expect", "LAMP == 1")
    assert (code, lines[-1]["state"]) == (0, "completed")
    drives = [line["state"] for line in lines if line.get("device") == "motor:gantry_bay"]
    pressed = drives.index("PRESSED")
    assert drives[pressed - 1 : pressed + 4] == ["DRIVEN", "PRESSED", "TRIPPED", "HELD", "DRIVEN"]


@pytest.mark.slow  # a page of the guide does the same
def test_it_is_redirected_to_the_simulator_where_parts_go_with_the_hand(capsys):  # R-K06, R-K03
    words = ["Q_MEZ[0] > 0.069", "Q_MEZ[0] < 0.071", "LAMP == 1"]
    expectations = [word for text in words for word in ("--expect", text)]
    code, lines = assembled(capsys, "--redirect", "motor_arm=motor_arm_kin", *expectations)
    assert (code, lines[-1]["state"], lines[-1]["actions_done"]) == (0, "completed", 17)
