import pytest

from kit.worlds.file_cells import ARM
from kit.worlds.robot_models import PLAIN, STATUE
from onika.desk.plan.robot_files import create_robot
from onika.store.site import open_site

SITE = open_site((), {}, None)


def model(folder, text=ARM, name="elbow.xml"):
    path = folder / name
    path.write_text(text)
    return path


def test_each_guess_has_a_comment_before_its_line(tmp_path):  # R-X19
    create_robot(model(tmp_path), tmp_path / "mine", SITE, say=lambda reason: reason.key)
    lines = (tmp_path / "mine" / "robot" / "elbow.robot").read_text().splitlines()
    assert lines[lines.index("HOME        0 0 0") - 1] == "# workcell.draft_home_zero"
    assert lines[lines.index("OPEN        0.03 0.076") - 1] == "# workcell.draft_width_tried"


def test_what_is_there_already_is_refused_and_nothing_is_written(tmp_path):  # R-X19
    (tmp_path / "mine" / "world").mkdir(parents=True)
    (tmp_path / "mine" / "world" / "elbow.world").write_text("mine")
    with pytest.raises(ValueError, match="is there already"):
        create_robot(model(tmp_path), tmp_path / "mine", SITE)
    assert [path.name for path in (tmp_path / "mine").rglob("*") if path.is_file()] == ["elbow.world"]


def test_a_name_of_the_search_path_is_refused(tmp_path):  # R-X19
    with pytest.raises(ValueError, match="search path already"):
        create_robot(model(tmp_path), tmp_path / "mine", SITE, "gantry")
    assert not (tmp_path / "mine").exists()


@pytest.mark.parametrize("name", ["../up", "a b", "x" * 65])
def test_what_is_no_name_is_refused(tmp_path, name):  # R-X19
    with pytest.raises(ValueError, match="expected a name"):
        create_robot(model(tmp_path), tmp_path / "mine", SITE, name)


def test_a_file_that_is_no_model_is_refused(tmp_path):  # R-X19
    for path in (tmp_path / "gone.xml", model(tmp_path, ARM, "elbow.txt"), model(tmp_path, STATUE)):
        with pytest.raises(ValueError, match=r"."):
            create_robot(path, tmp_path / "mine", SITE)
    assert not (tmp_path / "mine").exists()


def test_a_mesh_that_is_gone_is_told_before_what_comes_of_it(tmp_path):  # R-X19
    rod = '<geom type="capsule" size="0.02" fromto="0.06 0 0 0.3 0 0" mass="1"/>'
    text = PLAIN.replace(rod, '<geom type="mesh" mesh="gone" mass="1"/>')
    text = text.replace("<worldbody>", '<asset><mesh name="gone" file="gone.stl"/></asset><worldbody>')
    with pytest.raises(ValueError, match=r"gone\.stl, found none.*without that.*nothing was written"):
        create_robot(model(tmp_path, text), tmp_path / "mine", SITE)
    assert not (tmp_path / "mine").exists()


def test_an_arm_of_which_only_the_hand_is_driven_gets_motors_in_the_copy_of_its_model(tmp_path):  # R-X19
    motors = ARM[ARM.index('    <motor name="turn"') : ARM.index('    <position name="squeeze"')]
    given = model(tmp_path, ARM.replace(motors, ""))
    made = create_robot(given, tmp_path / "mine", SITE)
    assert "store.robot_motors" in {note.key for note in made.notes}
    assert "turn_motor" in (tmp_path / "mine" / "robot" / "elbow" / "elbow.xml").read_text()
    assert given.read_text() == ARM.replace(motors, "")
    robot = (tmp_path / "mine" / "robot" / "elbow.robot").read_text()
    assert "SPEED       2 2 0.5" in robot and "MOVES       squeeze" in robot


def test_a_model_that_lies_in_the_base_directory_is_not_changed_but_refused(tmp_path):  # R-X19
    motors = ARM[ARM.index('    <motor name="turn"') : ARM.index('    <position name="squeeze"')]
    (tmp_path / "robot").mkdir()
    given = model(tmp_path / "robot", ARM.replace(motors, ""))
    with pytest.raises(ValueError, match="which nothing drives"):
        create_robot(given, tmp_path, SITE)
    assert given.read_text() == ARM.replace(motors, "")
