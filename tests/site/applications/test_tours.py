"""Tours: applications that show the shipped jobs, in virtual time; and each job alone by what it leaves behind."""

import json

import numpy as np
import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from kit.labs.varied_job import varied
from onika.cli import main
from onika.laws import puma560

pytestmark = pytest.mark.site

HOME = (0.0, -1.570796, 1.570796, 0.0, 0.0, 0.0)
ABOVE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
"""Above the box with the triangle: the hand is at 0.7, 0.28, -0.125."""
AT_HOME = [
    f"Q_MEZ[{k}] {sign} {value + by}" for k, value in enumerate(HOME) for sign, by in ((">", -5e-3), ("<", 5e-3))
]


def run(capsys, name, *expectations):
    """The actions that were carried out, and the result, whose expectations came true."""
    expected = [word for expectation in expectations for word in ("--expect", expectation)]
    code = main(["run", str(name), "--virtual", "--json", *expected])
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines() if line.startswith("{")]
    assert (code, events[-1]["state"]) == (0, "completed"), events[-1]
    assert [entry["text"] for entry in events if entry["event"] == "warned"] == []
    return [entry["action"] for entry in events if entry["event"] == "began"], events[-1]


def test_the_tour_of_the_joints_comes_back_to_where_it_began(capsys):  # R-K08, R-B10
    done, _ = run(capsys, "tour_joints", *AT_HOME)
    assert done == [
        *("jdriveC elbow_up", "jpolyC nod", "jmove_rampC aside", "jmove_smoothC home"),
        "jpathC sway",
    ]


def test_the_tour_of_the_hand_goes_home_where_it_could_follow(capsys):  # R-K08
    done, _ = run(capsys, "tour_hand", *AT_HOME)
    assert done == ["jmoveC box2_aj", "cmove_arcC over_boxes over_box3", "trackC one_second", "jmoveC home"]


def test_the_tour_of_the_pad_is_led_by_strokes(capsys):  # R-B10, R-K07
    done, _ = run(capsys, "tour_led", *AT_HOME)
    assert done == ["jmoveC box2_aj", "jogC", "jjogC number_1", "jmoveC home"]


def test_the_tour_of_signals_needs_no_robot_and_takes_its_flows(capsys):  # R-B10, R-E05
    done, _ = run(capsys, "tour_signals", "COUNT == 3", "APART > 0.99", "APART < 1.01", "LASTED > 0.4")
    assert done == ["count_eventsC three", "whenC half", "chooseC number_1", "sortC"]


def left_behind(capsys, path, *icons):
    """Where joints and hand are after these actions, from above the box."""
    way = [job("jmoveC", "Joint job"), joints("above", *ABOVE, duration=3.0), *icons]
    program = Laboratory(path).application("once", way)
    program.write_text(program.read_text().replace("VERSION     1.3", "VERSION     2.0"))
    _, result = run(capsys, program, "Q_MEZ[0] > -9")
    return np.array(result["values"]["Q_MEZ"])


ONE_JOINT = job("jdriveC", "Single joint job"), target("it", "Single joint object", "2", "-0.9", "1.0")
POLYNOMIAL = (
    job("jpolyC", "Single polynomial job"),
    target("it", "Single polynomial object", "5", "0 0.9 -0.6 0 0", "1"),
)
PATH = np.outer(ABOVE, [1.0, 0, 0, 0, 0, 0]) + np.outer([0.3, -0.1, 0, 0, 0.1, 0], [0, 0, 3.0, -2.0, 0, 0])
PATH_TEXT = " ".join(f"{number:.9g}" for number in PATH.ravel())
POLYNOMIALS = job("jpathC", "Polynomial path job"), target("it", "Polynomial path object", PATH_TEXT, "1.5")
ASIDE = (0.4, -0.8, 2.5, 0.1, 1.2, 1.5)
BY = {
    "jdriveC": (ONE_JOINT, np.array([0, -0.9 - ABOVE[1], 0, 0, 0, 0])),
    "jpolyC": (POLYNOMIAL, np.array([0, 0, 0, 0, 0.3, 0])),
    "jpathC": (POLYNOMIALS, np.array([0.3, -0.1, 0, 0, 0.1, 0])),
    "jmove_rampC": ((job("jmove_rampC", "Joint job"), joints("it", *ASIDE, duration=2.0)), np.subtract(ASIDE, ABOVE)),
    "jmove_smoothC": (
        (job("jmove_smoothC", "Joint job"), joints("it", *ASIDE, duration=2.0)),
        np.subtract(ASIDE, ABOVE),
    ),
}


@pytest.mark.parametrize("name", BY)
def test_a_job_of_joints_leaves_each_where_its_target_says(capsys, tmp_path, name):  # R-K08, R-B10
    icons, by = BY[name]
    assert left_behind(capsys, tmp_path, *icons) - ABOVE == pytest.approx(by, abs=2e-3)


def test_one_joint_is_led_by_the_pad_as_far_as_its_stroke_and_no_other(capsys, tmp_path):  # R-B10, R-K07
    varied(Laboratory(tmp_path), "ledC", "jjogC", lines={"strokes": "LOCAL       STROKES 0:0.5:1\n"})
    moved = left_behind(capsys, tmp_path, job("ledC", "Index job"), target("it", "Index object", "5")) - ABOVE
    assert np.delete(moved, 4) == pytest.approx(np.zeros(5), abs=2e-3)
    fast = 0.5 * 0.2 * puma560.QDMAX[4]  # half a push, at a fifth of its speed, for a second
    assert moved[4] == pytest.approx(fast, abs=0.02 * fast)  # to a cycle of the pad


def test_a_path_that_the_pad_leads_is_written_down_and_played(capsys, tmp_path, monkeypatch):  # R-B10, R-K07
    monkeypatch.chdir(tmp_path)
    way = target("way", "File name object", "way.csv")
    after = left_behind(capsys, tmp_path / "lab", job("teachC", "File name job"), way)
    rows = np.loadtxt(tmp_path / "way.csv", delimiter=",", skiprows=1)[:, 1:]
    assert rows[0] == pytest.approx(np.array(ABOVE), abs=2e-3)
    assert np.ptp(rows, axis=0).max() > 0.02  # the hand went up
    assert rows[-1] == pytest.approx(after, abs=2e-3)
    played = left_behind(capsys, tmp_path / "lab", job("jplayC", "File name job"), way)
    assert played == pytest.approx(rows[-1], abs=2e-3)
