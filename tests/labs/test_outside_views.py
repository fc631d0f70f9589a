"""What the passive tasks with an outside partner tell it: display, logger, view."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.robot import published
from onika.laws.textbook import serial_arm
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.fake_partner import FakePartner

CONSTANTS = published(puma560, 0.0, 0.0, 0.0, 0.0)
HOME = np.array(puma560.HOME)


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


def asked_by(name, outsider):
    """What a task asks in its first cycle, and its bench."""
    code = shipped() / "signals" / "module" / f"{name}.py"
    bench = Bench(code, frequency=20, constants=CONSTANTS, local={"PARTNER": outsider.address}).init()
    bench["Q_MEZ"] = HOME
    bench.on().cycle()
    return outsider.accept().read(), bench


def test_the_display_is_shown_numbers_by_name_with_their_unit_and_time(outsider):  # R-F04
    question, bench = asked_by("display", outsider)
    assert (question["ask"], question["unit"], question["t"], question["task"]) == (
        "show",
        "rad",
        bench.now,
        "bench/module",
    )
    assert question["values"]["Q_MEZ"] == pytest.approx(list(HOME))


def test_the_logger_is_given_a_row_of_positions_and_references(outsider):  # R-F04
    question, _ = asked_by("logger", outsider)
    assert question["ask"] == "log"
    assert question["row"] == pytest.approx([*HOME, *[0.0] * 6])


def test_the_view_is_given_the_places_of_the_joints_and_the_pose_of_the_tool(outsider):  # R-F04
    question, _ = asked_by("view3d", outsider)
    pose = serial_arm(puma560.DH, tool=puma560.TOOL).forward(HOME)
    assert (question["ask"], np.shape(question["points"])) == ("pose", (8, 3))
    assert np.array(question["tool"]) == pytest.approx(pose)
    assert question["points"][-1] == pytest.approx(list(pose[:3, 3]))
    assert question["points"][0] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("name", ["display", "logger", "view3d"])
def test_they_are_passive(name):  # R-F04, §5.8.3
    code = shipped() / "signals" / "module" / f"{name}.py"
    assert Bench(code, constants=CONSTANTS, local={"PARTNER": "unix:/x"}).cls.passive
