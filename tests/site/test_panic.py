"""The panic button of the simulated arm, pressed in the midst of a move, in virtual and in wall time (§4.5.2)."""

import re
import subprocess

import pytest

from kit.process.cli_process import ONIKA

pytestmark = pytest.mark.site

TRIES = 5
PRESSED = """\
config jmoveC 0.0 -1.2 1.2 0.0 0.0 0.0 2.0
wait Q_MEZ[1] > -1.5 within 10
touch boxes panic_left 1
wait puma error within 5
"""
CLEARED = """\
touch boxes panic_left 0
clear puma
off jtraj
on puma
on jtraj 0.0 -1.2 1.2 0.0 0.0 0.0 2.0
wait jtraj off within 20
read Q_MEZ
touch boxes
"""


@pytest.fixture(params=[("--virtual",), ()], ids=["virtual", "wall"])
def operate(request):
    """Carry out lines in a runtime of their own: the exit code, and what was said; anew where the machine was late."""

    def carry_out(lines):
        words = [*ONIKA, "runtime", *request.param]
        for _ in range(TRIES):
            ran = subprocess.run(words, input=lines, capture_output=True, text=True, timeout=120, check=False)
            output = ran.stdout + ran.stderr
            if "has published nothing" not in output:
                return ran.returncode, output
        pytest.fail("the machine was late each time")

    return carry_out


def test_a_pressed_button_stops_a_move_which_is_completed_once_it_is_let_go_and_cleared(operate):  # R-K06, R-E08
    code, output = operate(PRESSED + CLEARED)
    assert code == 0, output
    lines = [
        "drive boxes:arm_left PRESSED: panic button pressed",
        "ERROR main/puma: cycle: ModuleError: panic button pressed; the drive holds",
        "drive boxes:arm_left TRIPPED: panic button let go",
        "drive boxes:arm_left HELD: cleared",
        "drive boxes:arm_left DRIVEN",
    ]
    places = [output.rindex(line) for line in lines]
    assert places == sorted(places), output
    (angles,) = re.findall(r"^Q_MEZ = (.*)$", output, re.MULTILINE)
    assert [float(angle) for angle in angles.split()] == pytest.approx([0, -1.2, 1.2, 0, 0, 0], abs=0.02)
    assert re.search(r"panic_left +1 pressed, 0 let go", output)


def test_as_long_as_it_is_pressed_a_clear_is_refused(operate):  # R-K06
    code, output = operate(f"{PRESSED}clear puma\n")
    assert code == 1
    assert "stdin:5: expected the change to be done, found puma: clear: ModuleError: panic button pressed" in output
    assert "TRIPPED" not in output
