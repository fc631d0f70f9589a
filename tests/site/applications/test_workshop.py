"""The workshop of any arm: its jobs show the modules that know no robot, by applications in virtual time (K05)."""

import json
import sys
from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.labs.varied_job import varied
from onika.cli import main

pytestmark = pytest.mark.site

PLANNER = Path(__file__).parents[3] / "docs" / "examples" / "planner.py"
HOME = (0.0, 0.4, 1.3, 0.0, 1.2, 0.0)
OUT = (0.6, 0.6, 1.1, 0.2, 1.3, 0.4)


def within(variable, value, by):
    return f"{variable} >= {value - by:.9g}", f"{variable} <= {value + by:.9g}"


def at(joints_, by=2e-3, variable="Q_MEZ"):
    return [words for k, value in enumerate(joints_) for words in within(f"{variable}[{k}]", value, by)]


AT_WORK = {
    "workshop_speeds": at(HOME),
    "workshop_sim": at(HOME),
    "workshop_torques": [
        *at(HOME),
        *("DEX[0] >= 0.1", "DEX[2] <= 0.81", "CERTAINTY == 0"),
        *within("LOAD_MEZ[0]", 0.0, 0.02),
        *(words for k in range(6) for words in within(f"TAU_EXT[{k}]", 0.0, 0.01)),
        *within("V_MEZ[0]", 0.0, 1e-4),
    ],
    "workshop_shaped": [*within("Q_MEZ[1]", OUT[1], 2e-3), *within("Q_LEAD[0]", OUT[0] + 0.2, 0.2)],
    "workshop_faults": [*at(OUT), *at(OUT, variable="Q_TRUE"), *within("Q_SMOOTH[1]", HOME[1], 2e-3)],
    "workshop_press": [*within("F_MEZ[2]", 8.0, 0.5), *within("X_MEZ[1,3]", 0.15, 1e-3), "X_MEZ[2,3] <= 0.318"],
    "aside_by_pid": ["HIT == 0", *within("Q_MEZ[1]", -1.570796, 2e-3)],
    "aside_without_forces": within("Q_MEZ[1]", -1.570796, 1e-6),
}
"""What holds at the end of each."""


def run(capsys, program, *expectations):
    """The result of a run with what was expected of it, and all that was told meanwhile."""
    options = [word for expectation in expectations for word in ("--expect", expectation)]
    code = main(["run", str(program), "--virtual", "--json", *options])
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines() if line.startswith("{")]
    assert events[-1]["exit"] == code
    return events[-1], events


@pytest.mark.parametrize("name", AT_WORK)
def test_a_job_of_the_workshop_does_what_it_says(capsys, name):  # R-K05
    result, events = run(capsys, name, *AT_WORK[name])
    assert (result["exit"], result["state"]) == (0, "completed"), json.dumps(result)
    assert [event["text"] for event in events if event["event"] == "warned"] == []


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("workshop_stuck", "joint 1 is measured to stand still"),
        ("workshop_drift", "joint 1 is measured 0.1"),
        ("workshop_lost", "nothing measured has changed"),
    ],
)
def test_a_fault_of_the_palette_ends_the_run_with_what_is_wrong(capsys, name, words):  # R-K05, R-X14
    result, _ = run(capsys, name)
    assert (result["state"], result["actions_done"]) == ("aborted", 0)
    assert "following is in error" in result["cause"]["text"] and words in result["cause"]["text"]


def test_who_watches_goes_off_where_nobody_listens_and_the_arm_goes_on(capsys):  # R-K05, R-F04
    result, events = run(capsys, "workshop_watched", *at(HOME), *within("GRIP_MEZ[0]", 0.04, 1e-3))
    assert (result["exit"], result["state"]) == (0, "completed"), json.dumps(result)
    told = json.dumps([event["text"] for event in events if event["event"] == "warned"])
    assert all(f"{name} has switched itself off" in told for name in ("display", "logger", "view3d", "csv_log"))


def test_an_outside_planner_leads_the_arm_of_the_workshop(capsys, tmp_path):  # R-K05, R-F04
    lab = Laboratory(tmp_path)
    partner = f"LOCAL       STARTS {sys.executable} {PLANNER}\nLOCAL       PATIENCE 20\nNOLOCAL     PARTNER\n"
    varied(lab, "planC", "jointed_planC", lines={"planner": partner})
    program = lab.application("plan", [job("planC", "Joint job"), joints("out", *OUT, duration=1.5)])
    result, _ = run(capsys, program, *at(OUT))
    assert (result["exit"], result["state"]) == (0, "completed"), json.dumps(result)
