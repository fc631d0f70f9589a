from dataclasses import replace

from msgspec import structs

from onika.desk.plan.robot_programs import RobotPrograms
from onika.files import kept
from onika.model import job_pictures
from onika.model.initials import drawn
from onika.wire.robot_draft import RobotDraft

DRAFT = RobotDraft(
    home=(0.0,) * 6, away=(0.3,) * 6, seconds=2.0, line=(0, 0, 1, 0, 1, 0, 0.4, 0, 0.5), opening=(0.08, 0.0, 10.0)
)
ALL = RobotPrograms("crane", DRAFT)


def names(programs):
    return {path for path, _ in programs.texts()}


def test_an_arm_of_six_axes_with_a_gripper_gets_all_jobs():  # R-X19
    assert {path for path in names(ALL) if path.startswith("conf/")} == {
        "conf/jmove_craneC.conf", "conf/cmove_craneC.conf", "conf/grip_craneC.conf"}  # fmt: skip
    assert {"appl/crane_tour.appl", "tests/crane_tour.test", "module/crane.rmod", "dict/crane_home.onk"} <= names(ALL)


def test_there_is_no_job_for_what_the_robot_does_not_have():  # R-X19
    bare = replace(ALL, draft=structs.replace(DRAFT, line=(), opening=()))
    assert {path for path in names(bare) if path.startswith("conf/")} == {"conf/jmove_craneC.conf"}
    assert {path for path in names(bare) if path.startswith("module/")} == {"module/crane.rmod"}


def test_a_base_is_driven_on_and_back_and_an_arm_on_it_moves_in_between():  # R-X19
    driving = replace(ALL, draft=RobotDraft(ahead=(0.3, 0.0, 0.0)))
    assert {path for path in names(driving) if path.startswith(("module/", "conf/"))} == {
        "module/crane_base.rmod", "conf/drive_craneC.conf"}  # fmt: skip
    both = replace(ALL, draft=structs.replace(DRAFT, ahead=(0.3, 0.0, 0.0)))
    (flow,) = kept.read(dict(both.texts())["tests/crane_tour.test"], "crane_tour", "f")[0].flows
    assert [flow.actions[at].name for at in (0, -1)] == ["drive_craneC crane_ahead", "drive_craneC crane_start"]
    assert [demand.address for demand in flow.at_end] == ["Q_MEZ", "P_TRUE[0]", "P_TRUE[1]"]
    assert ("crane_base", "crane:base_stand") in flow.robots


def test_the_test_demands_that_the_joints_are_home_in_the_end():  # R-X19
    text = dict(ALL.texts())["tests/crane_tour.test"]
    kept_run, faults = kept.read(text, "crane_tour", "crane_tour.test")
    assert faults == ()
    assert kept_run.flows[0].at_end[0].values == DRAFT.home
    assert kept_run.flows[0].robots == (("crane", "crane:crane_stand"), ("crane_hand", "crane:gripper_stand"))
    assert [action.name.split()[0] for action in kept_run.flows[0].actions] == [
        "grip_craneC", "jmove_craneC", "cmove_craneC", "grip_craneC", "jmove_craneC"]  # fmt: skip


def test_icons_show_the_robot_and_what_it_does_and_other_ones_bear_letters():  # R-X19, R-B11
    home, away = (drawn(letters) for letters in ("X", "Y"))
    texts = dict(replace(ALL, draft=structs.replace(DRAFT, pictures=(home.rows, away.rows))).texts())
    shown = {"home": home, "away": away, "open": job_pictures.of_opened(), "line": job_pictures.of_goal()}
    for name, picture in shown.items():
        assert rows_of(texts[f"dict/crane_{name}.onk"]) == picture.rows
    assert rows_of(texts["dict/jmove_craneC.onk"]) == job_pictures.of_joints(home.rows, away.rows).rows
    assert rows_of(texts["dict/grip_craneC.onk"]) == job_pictures.of_hand().rows
    assert rows_of(dict(ALL.texts())["dict/jmove_craneC.onk"]) == drawn("jmove_craneC").rows


def rows_of(text):
    return tuple(line.split()[1] for line in text.splitlines() if line.startswith("PICT"))
