"""A laboratory that is files: a gantry over a bench (requirement X19)."""

import json
from shutil import copytree

import pytest

from onika.cli import main
from onika.desk.plan.preparation import prepare_run
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.store.world_source import gather_world

pytestmark = pytest.mark.site

LAB = shipped() / "gantry"


def run(capsys, *words):
    code = main(["run", *words, "--json"])
    return code, json.loads(capsys.readouterr().out.splitlines()[-1])


def test_its_tour_ends_where_it_began_and_is_the_same_each_time(capsys):  # R-X19
    home = ("--expect", "Q_MEZ[0] < 0.001", "--expect", "Q_MEZ[2] < 0.001")
    results = [run(capsys, "gantry_tour", "--virtual", *home) for _ in range(2)]
    assert [(code, result["state"]) for code, result in results] == [(0, "completed")] * 2
    assert results[0][1]["hash"] == results[1][1]["hash"]


def test_the_block_is_put_on_its_pad_and_the_lamp_is_lit(capsys):  # R-X19, R-K05
    code, result = run(capsys, "gantry_lamp", "--virtual", "--expect", "LAMP == 1")
    assert (code, result["state"], result["notes"]) == (0, "completed", [])


def test_the_camera_at_its_wrist_comes_over_the_blue_block_within_three_seconds(capsys):  # R-F05, R-K04, R-X06
    over = [
        f"Q_MEZ[{axis}] {than}" for axis, than in ((0, "> -0.463"), (0, "< -0.457"), (1, "> -0.153"), (1, "< -0.147"))
    ]
    middle = ["UV[0] > 157.5", "UV[0] < 161.5", "UV[1] > 117.5", "UV[1] < 121.5"]
    results = []
    for _ in range(2):
        results.append(run(capsys, "gantry_blue", "--virtual", *(f"--expect={fact}" for fact in (*over, *middle))))
        if "cannot render" in str(results[-1]):
            pytest.skip("this machine cannot render")
    assert [(code, result["state"]) for code, result in results] == [(0, "completed")] * 2
    assert results[0][1]["hash"] == results[1][1]["hash"]
    assert results[0][1]["runtime_s"] < 2.6 + 3.0


def test_a_point_that_was_clicked_in_the_picture_comes_to_its_middle(capsys):  # R-F05, R-B10
    middle = ["UV[0] > 157.5", "UV[0] < 161.5", "UV[1] > 117.5", "UV[1] < 121.5"]
    code, result = run(capsys, "gantry_point", "--virtual", *(f"--expect={fact}" for fact in middle))
    if "cannot render" in str(result):
        pytest.skip("this machine cannot render")
    assert (code, result["state"]) == (0, "completed")


def test_where_the_gripper_is_not_opened_the_lamp_stays_dark(tmp_path, capsys):  # R-X19
    copytree(LAB, tmp_path, dirs_exist_ok=True)
    program = tmp_path / "appl" / "gantry_lamp.appl"
    whole = program.read_text()
    program.write_text(whole.replace("UI          0.09", "UI          0.03"))
    code, _ = run(capsys, str(program), "--virtual", "--expect", "LAMP == 0")
    assert code == 0


def test_its_plan_brings_the_files_of_its_world():  # R-X19
    plan = prepare_run("gantry_tour", open_site([], {}, None)).plan
    (bench,) = plan.worlds
    assert bench == gather_world("bench", open_site([], {}, None))[0]
    names = {file.name for file in bench.files}
    assert {"world/bench.world", "robot/gantry.robot", "robot/gantry.xml"} <= names


@pytest.mark.parametrize(
    ("file", "old", "new", "line"),
    [
        ("world/bench.world", "FLOOR       0", "FLOOR       low", 4),
        ("robot/gantry.robot", "TOOL        tip", "TOOL        top", 6),
        ("robot/gantry.robot", "FILE        gantry.xml", "FILE        crane.xml", 3),
        ("robot/gantry.robot", "EOF", "", 17),
    ],
)
def test_a_broken_world_is_told_with_its_line_before_anything_moves(tmp_path, capsys, file, old, new, line):  # R-X19
    copytree(LAB, tmp_path, dirs_exist_ok=True)
    broken = tmp_path / file
    broken.write_text(broken.read_text().replace(old, new))
    assert main(["run", str(tmp_path / "appl" / "gantry_tour.appl"), "--virtual"]) != 0
    told = "".join(capsys.readouterr())
    assert f"{broken}:{line}: expected" in told
    assert "1/3" not in told


def test_it_goes_down_until_the_hill_is_near_and_over_it_always_as_near(tmp_path, capsys):  # R-K08, R-K05
    near = ("--expect", "SENSE > 0.118", "--expect", "SENSE < 0.122")
    behind = run(capsys, "hill_tour", "--virtual", *near, "--expect", "Q_MEZ[0] > 0.18", "--expect", "Q_MEZ[2] > 0.1")
    assert (behind[0], behind[1]["state"], behind[1]["notes"]) == (0, "completed", [])
    copytree(LAB, tmp_path, dirs_exist_ok=True)
    program = tmp_path / "appl" / "hill_tour.appl"
    whole = program.read_text()
    last = whole.rindex("ROUTINE     follow_hillC")
    program.write_text(whole[:last] + whole[whole.rindex("ENDFLOW") :])
    on_top = ("--expect", "Q_MEZ[2] < 0.025", "--expect", "Q_MEZ[2] > 0.015")
    code, result = run(capsys, str(program), "--virtual", *near, *on_top)
    assert (code, result["state"]) == (0, "completed")
