"""What is foreseen of programs: of those that are shipped no false alarm, of planted faults each one."""

import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from onika.desk.plan.preparation import prepare_run
from onika.desk.run import forecast as room
from onika.desk.run.forecast import Forecast
from onika.store.shipped import shipped_directories
from onika.store.site import open_site

pytestmark = pytest.mark.site

SITE = open_site([], {}, None)
PATHS = [path for base in shipped_directories() for path in (base / "appl").glob("*.appl")]
NAMES = sorted(path.stem for path in PATHS)
WITHOUT_WORLD = {path.stem for path in PATHS if path.parent.parent.name == "folders"}
"""Those that ask for what stands outside of every workcell: they are foreseen as far as that goes."""
PARTS = {"visit"}
"""Those with a hole, which other programs fill."""
WITHOUT_LAMP = {"modular_out", "plate_tour", "rover_tour", "turn_knob"}
"""Nothing is told of how their worlds stand in the end: they have no lamp."""
ENDLESS = {"wave_on"}
ENOUGH_S = 60.0
"""What is foreseen of one that never ends; all others are shorter."""
AT_ONCE = {"assemble", "gantry_lamp", "touch_down", "tour_hand", "two_arms", "visit_boxes", "wave_on"} | WITHOUT_WORLD
"""Each of these differs from the others; those wait for the long tests."""


def shipped_programs():
    """Their names, most of them marked as slow."""
    for name in NAMES:
        if name not in PARTS:
            yield pytest.param(name, marks=() if name in AT_ONCE else pytest.mark.slow)


@pytest.mark.parametrize("name", list(shipped_programs()))
def test_of_a_shipped_program_nothing_is_told_that_is_meant(name, monkeypatch):  # R-E16
    monkeypatch.setattr(room, "LONGEST_S", ENOUGH_S)
    prepared = prepare_run(name, SITE)
    result = Forecast(prepared.plan, prepared.targets).carry_out()
    assert [str(mishap.text) for mishap in result.mishaps] == []
    if name not in WITHOUT_WORLD:
        assert result.cause.key == ("desk.forecast_long" if name in ENDLESS else "")
        has_lamp = any(flow.worlds for flow in prepared.plan.flows) and name not in WITHOUT_LAMP
        assert bool(result.standing) == has_lamp


# Planted faults

TRIANGLE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
WAVES = (-0.21463, -0.745079, 2.926112, 0.0, 0.96056, 1.356167)
WAVES_RIGHT = (-0.274507, -1.025077, 3.432307, 0.0, 0.734363, -1.845304)
"""Above the boxes with these signs, the last with the right arm."""
OPEN, CLOSE = [job("opengripC")], [job("closegripC")]


def to(angles, arm=""):
    """To these joints."""
    return [job(f"jmove{arm}C", "Joint job"), joints("there", *angles, duration=3.0)]


def line(x, y, z, duration=2.0, arm=""):
    """On a straight line to a place, fingers down."""
    pose = f"0.0 0.0 -1.0 0.0 1.0 0.0 {x} {y} {z}"
    return [job(f"cmove{arm}C", "Cartesian job"), target("at", "Cartesian object", pose, str(duration))]


LOW = [job("cshiftC", "Relative job"), target("down", "Relative object", "0.0 0.0 -0.2", "2.0")]
TAKE = OPEN + to(TRIANGLE) + line(0.7, 0.28, -0.3346) + CLOSE
PLANTED = {
    "the hand is shut": (to(TRIANGLE) + line(0.7, 0.28, -0.3346), 2, "the hand touches the box with the triangle"),
    "too low": (to(TRIANGLE) + line(0.7, 0.14, -0.2) + line(0.7, 0.14, -0.45), 3, "the hand touches the table"),
    "a box in its way": (
        to(TRIANGLE) + line(0.7, 0.14, -0.32) + line(0.7, -0.1, -0.32, 3.0),
        3,
        "the hand touches the box with the waves",
    ),
    "too far down from here": (to(TRIANGLE) + LOW, 2, "the hand touches the box with the triangle"),
    "joints that lead into the table": (to((0.18, 0.1, 2.2, 0.0, 0.6, 0.0)), 1, "the hand touches the table"),
    "a little beside a box": (OPEN + to(WAVES) + line(0.72, 0.03, -0.36), 3, "the hand touches the box with the waves"),
    "nothing to take": (
        OPEN + to(TRIANGLE) + line(0.7, 0.28, -0.2) + CLOSE,
        4,
        "the hand closes on nothing: it is empty",
    ),
    "let go too high": (
        TAKE + line(0.7, 0.28, -0.15) + OPEN,
        6,
        "the hand lets the box with the triangle go in the air",
    ),
    "a box against a box": (
        TAKE + line(0.7, 0.28, -0.3) + line(0.7, 0.0, -0.3, 3.0),
        6,
        "the box with the triangle in the hand touches the box with the waves",
    ),
    "a box put down too low": (
        TAKE + line(0.7, 0.28, -0.2) + line(0.7, 0.14, -0.2) + line(0.7, 0.14, -0.42),
        7,
        "the hand touches the table",
    ),
    "the right hand is shut": (
        to(WAVES_RIGHT, "_right") + line(0.7, 0.0, -0.36, arm="_right"),
        2,
        "the hand touches the box with the waves",
    ),
}


@pytest.mark.parametrize("fault", PLANTED)
def test_each_planted_fault_is_told_at_its_action(tmp_path, fault):  # R-E16
    steps, number, words = PLANTED[fault]
    path = Laboratory(tmp_path).application("planted", steps)
    prepared = prepare_run(str(path), SITE)
    result = Forecast(prepared.plan, prepared.targets).carry_out()
    actions = prepared.plan.flows[0].actions
    told = [(actions.index(mishap.action) + 1, str(mishap.text)) for mishap in result.mishaps]
    assert (number, words) in told
    assert {at for at, _ in told} == {number}


def test_two_arms_that_go_to_one_place_are_told_to_meet(tmp_path):  # R-E16
    path = Laboratory(tmp_path).application("meet", to(WAVES), to(WAVES_RIGHT, "_right"), parallel=True)
    prepared = prepare_run(str(path), SITE)
    result = Forecast(prepared.plan, prepared.targets).carry_out()
    assert "the left arm meets the right arm" in [str(mishap.text) for mishap in result.mishaps]
