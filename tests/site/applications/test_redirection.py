"""Applications on other robots than they were made for, from the command line, their files as they were (E09)."""

import os

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.worlds.installed_world import install_world
from onika.cli import main
from onika.store.site import open_site

pytestmark = pytest.mark.site


def run(capsys, *words):
    code = main(["run", *words, "--virtual"])
    captured = capsys.readouterr()
    return code, captured.out + captured.err


@pytest.mark.parametrize("robot", ["scara", "puma_kin"])
def test_the_assembly_is_done_by_another_robot(capsys, robot):  # R-E09, R-K03
    path = open_site([], {}, None).application_file("assemble")
    before = path.read_bytes()
    code, output = run(capsys, "assemble", "--redirect", f"puma={robot}", "--expect", "LAMP == 1")
    assert (code, "expect LAMP == 1: yes" in output) == (0, True)
    assert output.count("is re-resolved for scara") == (4 if robot == "scara" else 0)
    assert path.read_bytes() == before


def test_each_flow_is_redirected_by_itself_under_the_names_that_flows_are_given(capsys):  # R-E09
    words = ("two_arms", "--subsystem", "one", "--subsystem", "two")
    assert run(capsys, *words, "--redirect", "one:puma=puma_kin", "--redirect", "1:puma_right=puma_right_kin")[0] == 0
    code, output = run(capsys, *words, "--redirect", "one:puma=puma_kin", "--redirect", "one:puma_right=puma_right_kin")
    assert code == 2
    assert "expected a task of flow 0" in output


def test_what_the_other_robot_cannot_do_is_told_before_anything_moves(capsys):  # R-E09, R-X02
    code, output = run(capsys, "go_home", "--redirect", "puma=scara")
    assert (code, "nothing moved (1 fault)" in output) == (2, True)
    assert "flow0, action 1: jmoveC home" in output


def test_an_arm_whose_code_is_not_here_can_still_be_replaced(capsys, tmp_path):  # R-E09
    lab = Laboratory(tmp_path)
    text = (open_site([], {}, None).home_of_task("puma").task_file("puma")).read_text(encoding="utf-8")
    lab.task("away", text.partition("EOF")[0].replace("MODULE      arm", "MODULE      away"))
    lab.configuration("gripC", "away 500", "gripper 100", "led_monitor 50", "opengrip 50")
    path = str(lab.application("open_it", [job("gripC")]))
    assert run(capsys, path)[0] == 2
    assert run(capsys, path, "--redirect", "away=puma")[0] == 0


def test_a_target_of_such_an_arm_is_told_because_nobody_knows_its_pose(capsys, tmp_path):  # law 26, R-X02
    lab = Laboratory(tmp_path)
    text = (open_site([], {}, None).home_of_task("puma").task_file("puma")).read_text(encoding="utf-8")
    lab.task("away", text.partition("EOF")[0].replace("MODULE      arm", "MODULE      away"))
    lab.configuration("goC", *(f"{name} 500" for name in ("away", "diff", "gravcomp", "pd", "torque_sum", "jtraj")))
    path = str(lab.application("go", [job("goC", "Joint job"), joints("there", 0.2, -0.6, 2.7, 0.0, 1.0, 0.0)]))
    code, output = run(capsys, path, "--redirect", "away=scara")
    assert code == 2
    assert "expected the robot that they were made for, away, to know their poses, found there: none" in output


def test_a_target_of_four_joints_moves_the_scara_and_by_its_pose_the_puma(capsys, tmp_path):  # R-D13, law 26
    steps = [job("jmove_scaraC", "Joint job"), joints("there", 0.0, 0.9, 0.05, -0.8)]
    path = str(Laboratory(tmp_path).application("go", steps))
    assert run(capsys, path, "--expect", "Q_MEZ[1] > 0.89")[0] == 0
    code, output = run(capsys, path, "--redirect", "scara=puma")
    assert (code, "there is re-resolved for puma" in output) == (0, True)


@pytest.mark.parametrize("text", ["puma", "a=b=c", ":puma=scara"])
def test_a_redirection_that_is_none_is_refused_as_a_word(capsys, text):  # R-E09
    with pytest.raises(SystemExit):
        main(["run", "assemble", "--redirect", text])
    assert "expected [FLOW:]TASK=TASK" in capsys.readouterr().err


@pytest.fixture
def cell(tmp_path, monkeypatch):
    """A world that counts as real is installed; it has the devices of `boxes`."""
    folder = tmp_path / "packages"
    folder.mkdir()
    search = os.pathsep.join(filter(None, (str(install_world(folder, "cell")), os.environ.get("PYTHONPATH"))))
    monkeypatch.setenv("PYTHONPATH", search)


def test_one_arm_is_simulated_beside_another_one_in_its_own_world(capsys, tmp_path):  # R-E09
    def flow(first, duration):
        meet = job("jmoveC", "Joint job", "SYNCHTAG meet")
        begin = joints("begin", first, -1.1, 2.2, 0.0, 0.7, 0.8, duration=duration)
        return [job("jmoveC", "Joint job"), begin, meet, joints("end", -first, -1.1, 2.2, 0.0, 0.7, 0.8)]

    path = str(Laboratory(tmp_path).application("twins", flow(0.8, 1.0), flow(-0.6, 2.0), parallel=True))
    assert run(capsys, path)[0] == 2, "one arm cannot be driven by two flows"
    goals = ("--expect", "flow0/Q_MEZ[0] < -0.79", "--expect", "flow1/Q_MEZ[0] > 0.59")
    code, output = run(capsys, path, "--redirect", "1:boxes:=boxes@copy:", *goals)
    assert (code, output.count(": yes")) == (0, 2), output
    assert "flow0 drives boxes (simulated)" in output
    assert "flow1 drives boxes@copy (simulated)" in output


@pytest.mark.usefixtures("cell")
@pytest.mark.slow  # the page's test of worlds does the same in wall time
def test_one_arm_is_real_and_the_other_simulated_in_wall_time_and_that_is_told(capsys):  # R-E09
    goals = ("--expect", "flow0/Q_MEZ[1] < -1.5", "--expect", "flow1/Q_MEZ[1] < -1.5")
    code = main(["run", "two_arms", "--redirect", "0:boxes:=cell:", *goals])
    captured = capsys.readouterr()
    assert code == 0, captured.out + captured.err
    assert "flow0 drives cell (real)" in captured.out + captured.err
    assert "flow1 drives boxes (simulated)" in captured.out + captured.err


@pytest.mark.usefixtures("cell")
@pytest.mark.parametrize(
    ("world", "reason"),
    [
        ("cell@copy", "expected a simulated world to make a copy of, found cell, which is real"),
        ("atlantis", "atlantis"),
        ("cell", "cell:arm_left"),
    ],
)
def test_a_world_that_cannot_stand_there_is_told_before_anything_moves(capsys, tmp_path, world, reason):  # R-E09
    steps = [job("jmoveC", "Joint job"), joints("there", 0.8, -1.1, 2.2, 0.0, 0.7, 0.8)]
    path = str(Laboratory(tmp_path).application("twins", steps, steps, parallel=True))
    code, output = run(capsys, path, "--redirect", "0:boxes:=cell:", "--redirect", f"1:boxes:={world}:")
    assert (code, reason in output) == (2, True), output
