"""Generic tasks dropped into a shipped job, in virtual time: filters, servos, watches, logs, teleoperation."""

import json

import numpy as np
import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from kit.labs.varied_job import placed, varied
from onika.cli import main
from onika.laws import puma560
from onika.laws.textbook import serial_arm

pytestmark = pytest.mark.site

GOAL = (0.7, -1.1, 1.2, 0.2, 0.3, 0.4)
ABOVE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
TRUE = {"puma": "SVARALIAS   Q_MEZ = Q_TRUE\n"}
"""What the arm measures is called so; what is dropped in writes Q_MEZ in its place."""
BETWEEN = "SVARALIAS   Y = Q_TRUE", "SVARALIAS   Z = Q_MEZ"
WISHED = {"jtraj": "SVARALIAS   Q_REF = Q_WISH\nSVARALIAS   Q^_REF = Q^_WISH\n"}
SUMMED = {"torque_sum": "SVARALIAS   TAU_REF = TAU_SUM\n"}
NOTCHED = "SVARALIAS   TAU_IN = TAU_SUM", "SVARALIAS   TAU_OUT = TAU_REF"


def ran(capsys, path, icons, *watched):
    """The result of an application of job `tryC`; what is watched stands in its values."""
    program = Laboratory(path).application("try_it", icons)
    expected = [word for name in watched for word in ("--expect", f"{name} > -1e9")]
    code = main(["run", str(program), "--virtual", "--json", *expected])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["state"]) == (0, "completed"), result
    return {name: np.array(value) for name, value in result["values"].items()}


def moved(capsys, path, *watched):
    """The same of a move of the joints to GOAL."""
    return ran(capsys, path, [job("tryC", "Joint job"), joints("aside", *GOAL, duration=2.0)], "Q_MEZ[0]", *watched)


CASES = {
    "lowpass": ([placed("lowpass", 500, *BETWEEN, "LOCAL       CUTOFF 100")], TRUE),
    "median": ([placed("median", 500, *BETWEEN, "LOCAL       WINDOW 3")], TRUE),
    "notch": ([placed("notch", 500, *NOTCHED, "LOCAL       MIDDLE 100")], SUMMED),
    "ratelimit": ([placed("ratelimit", 250, "LOCAL       FASTEST 5")], WISHED),
    "fence": ([placed("fence", 250)], WISHED),
    "override": (
        [placed("override", 250, "LOCAL       SHARE 0.6")],
        {"jtraj": f"{WISHED['jtraj']}LOCAL       SETTLE 9\n"},
    ),
    "friction": ([placed("friction", 500, *NOTCHED)], SUMMED),
}


@pytest.mark.parametrize("name", CASES)
def test_an_arm_comes_to_its_target_through_what_is_dropped_in(capsys, tmp_path, name):  # R-K05
    dropped_in, lines = CASES[name]
    varied(Laboratory(tmp_path), "tryC", "jmoveC", dropped_in, lines)
    assert moved(capsys, tmp_path)["Q_MEZ"] == pytest.approx(np.array(GOAL), abs=2e-3)


def test_a_median_mends_the_drop_outs_of_a_measurement(capsys, tmp_path):  # R-K05, R-X14
    lost = placed("drop_out", 500, "SVARALIAS   Z = Q_LOST", "LOCAL       SHARE 0.05", "LOCAL       LASTS 0.002")
    median = placed("median", 500, "SVARALIAS   Y = Q_LOST", "SVARALIAS   Z = Q_MEZ", "LOCAL       WINDOW 3")
    varied(Laboratory(tmp_path), "tryC", "jmoveC", [lost, median, placed("following", 250)], TRUE)
    assert moved(capsys, tmp_path)["Q_MEZ"] == pytest.approx(np.array(GOAL), abs=5e-3)


def test_a_servo_with_an_integral_stands_in_for_the_one_without(capsys, tmp_path):  # R-K05
    varied(Laboratory(tmp_path), "tryC", "jmoveC", [placed("pid", 500, "LOCAL       RATE 2")], without=["pd"])
    assert moved(capsys, tmp_path)["Q_MEZ"] == pytest.approx(np.array(GOAL), abs=2e-3)


def test_a_fence_stops_a_wish_at_its_margin(capsys, tmp_path):  # R-K05
    fence = placed("fence", 250, "LOCAL       MARGIN 1.0")
    lines = {"jtraj": WISHED["jtraj"] + "LOCAL       AWAY 9\n"}  # it is not to mind that the fence keeps it away
    varied(Laboratory(tmp_path), "tryC", "jmoveC", [fence], lines)
    icons = [job("tryC", "Joint job"), joints("far", 2.5, *GOAL[1:], duration=4.0)]
    assert ran(capsys, tmp_path, icons, "Q_MEZ[0]")["Q_MEZ"][0] == pytest.approx(2.79253 - 1.0, abs=5e-3)


def test_what_a_joint_did_is_written_down_as_rows_and_figures(capsys, tmp_path):  # R-K05
    file = tmp_path / "rows.csv"
    log, figures = placed("csv_log", 50, f"LOCAL       FILE {file}"), placed("figures", 50, "LOCAL       SPAN 60")
    varied(Laboratory(tmp_path), "tryC", "jmoveC", [log, figures])
    least, greatest = moved(capsys, tmp_path, "Q_FIGURES[0]")["Q_FIGURES"][:2]
    rows = np.loadtxt(file, delimiter=",", skiprows=1)
    assert np.diff(rows[:, 0]) == pytest.approx(np.full(len(rows) - 1, 0.02))
    assert rows[-1, 1:] == pytest.approx(np.array(GOAL), abs=5e-3)
    assert (least, greatest) == (pytest.approx(rows[:, 1].min(), abs=1e-6), pytest.approx(rows[:, 1].max(), abs=1e-6))


@pytest.mark.parametrize(("down", "hit"), [("0 0 0.05", 0), ("0 0 -0.25", 1)])
def test_what_the_hand_meets_is_told_and_free_motion_is_not(capsys, tmp_path, down, hit):  # R-K05
    blocked = {"cshift": "LOCAL       AWAY 1\n"}  # else that ends the run before anybody reads HIT
    varied(Laboratory(tmp_path), "tryC", "cshiftC", [placed("collide", 250)], blocked)
    icons = [
        *(job("jmoveC", "Joint job"), joints("above", *ABOVE, duration=3.0)),
        *(job("tryC", "Relative job"), target("by", "Relative object", down, "3.0")),
    ]
    assert ran(capsys, tmp_path, icons, "HIT")["HIT"] == hit


def test_what_presses_on_an_arm_is_seen_joint_by_joint(capsys, tmp_path):  # R-K05
    varied(Laboratory(tmp_path), "tryC", "pressC", [placed("observer", 250)])
    icons = [
        *(job("jmoveC", "Joint job"), joints("above", *ABOVE, duration=3.0)),
        *(job("cshiftC", "Relative job"), target("by", "Relative object", "0 0 -0.15", "2.0")),
        *(job("tryC", "Force job"), target("hard", "Force object", "0 0 -30 0 0 0")),
    ]
    values = ran(capsys, tmp_path, icons, "TAU_EXT[0]", "Q_MEZ[0]", "F_MEZ[0]")
    arm = serial_arm(puma560.DH, tool=puma560.TOOL)
    assert values["TAU_EXT"] == pytest.approx(arm.jacobian(values["Q_MEZ"]).T @ values["F_MEZ"], abs=1.5)
    assert np.abs(values["TAU_EXT"]).max() > 10.0


def test_a_force_is_held_while_the_hand_goes_on_across_it(capsys, tmp_path):  # R-K05, R-B10
    held = [placed("tool_force", 250), placed("force", 250, "LOCAL       FORCE 15", "LOCAL       FAR 0.2")]
    lines = {"ctraj": "SVARALIAS   X_REF = X_PATH\nLOCAL       AWAY 1\nLOCAL       SETTLE 0.1\n"}
    varied(Laboratory(tmp_path), "tryC", "cmoveC", held, lines)
    across = "0.0 0.0 -1.0 0.0 1.0 0.0 0.7 0.29 -0.285"
    icons = [
        *(job("jmoveC", "Joint job"), joints("above", *ABOVE, duration=3.0)),
        *(job("cshiftC", "Relative job"), target("near", "Relative object", "0 0 -0.16", "2.0")),
        *(job("tryC", "Cartesian job"), target("across", "Cartesian object", across, "6.0")),
    ]
    values = ran(capsys, tmp_path, icons, "F_MEZ[0]", "X_MEZ[0,0]")
    assert values["F_MEZ"][2] == pytest.approx(15.0, abs=2.0)
    assert values["X_MEZ"][1, 3] == pytest.approx(0.29, abs=3e-3)


def test_a_follower_does_what_its_leader_does(capsys, tmp_path):  # R-K05, R-K07
    aliases = "SVARALIAS   Q_REF = Q_LEAD", "SVARALIAS   Q^_REF = Q^_LEAD"
    leader = placed(
        "jgenerator", 250, *aliases, "LOCAL       WAVE step", "LOCAL       AMPLITUDE 0.2", "LOCAL       DELAY 0.2"
    )
    follower = placed("mirror", 250, "LOCAL       SCALE -0.5")
    varied(Laboratory(tmp_path), "tryC", "jmoveC", [leader, follower, placed("pause", 50)], without=["jtraj"])
    icons = [job("tryC", "Pause job"), target("a_while", "Pause object", "2.0")]
    assert ran(capsys, tmp_path, icons, "Q_MEZ[0]")["Q_MEZ"][0] == pytest.approx(-0.1, abs=2e-3)


def test_a_speed_along_the_tool_leads_it_along_its_own_axes(capsys, tmp_path):  # R-K07
    lines = {"deadband": "SVARALIAS   V_REF = V_TOOL\n", "strokes": "LOCAL       STROKES 2:-0.6:1\n"}
    varied(Laboratory(tmp_path), "tryC", "jogC", [placed("frame", 250)], lines)
    icons = [job("jmoveC", "Joint job"), joints("above", *ABOVE, duration=3.0), job("tryC")]
    hand = ran(capsys, tmp_path, icons, "X_MEZ[2,3]")["X_MEZ"][:3, 3]
    assert hand[:2] == pytest.approx([0.7, 0.28], abs=2e-3)
    assert hand[2] == pytest.approx(-0.125 + 0.1 * (0.5 * 5 / 9 + 0.5 * (5 / 9) ** 3), abs=3e-3)  # back along it: up
