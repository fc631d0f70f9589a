"""Worlds and robots that are checked as files."""

import pytest

from kit.worlds.file_cells import CELL
from onika.desk.plan.world_survey import world_sources
from onika.desk.run.survey import survey
from onika.store.site import open_site


@pytest.fixture
def lab(tmp_path):
    for name, text in CELL.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def test_a_robot_is_looked_at_in_its_world_and_else_by_itself(lab):  # R-X19
    site, robots = open_site([lab], {}, None), sorted((lab / "robot").glob("*.robot"))
    (cell,), faults = world_sources([lab / "world" / "cell.world", *robots], site)
    assert (cell.world, faults) == ("cell", [])
    sources, faults = world_sources(robots, site)
    assert ([source.world for source in sources], faults) == (["elbow", "stiff"], [])


def test_everything_wrong_with_worlds_and_robots_is_told_with_its_line(lab):  # R-B07, R-X19
    world, robot = lab / "world" / "cell.world", lab / "robot" / "stiff.robot"
    world.write_text(CELL["world/cell.world"].replace("NEAR cube.top", "NEAR cube.bottom"))
    robot.write_text(CELL["robot/stiff.robot"].replace("TOOL tip", "TOOL top"))
    files, faults = survey(lab, open_site([], {}, None))
    assert len(files) == 3
    assert [(fault.place.file, fault.place.line) for fault in faults] == [
        (str(robot), 4),
        (str(world), 18),
        (str(world), 20),
    ]
    assert [fault.place.line for fault in survey(robot, open_site([], {}, None))[1]] == [4]
