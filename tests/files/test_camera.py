"""The block CAMERA: what is wrong with a line is told with its number."""

import pytest

from onika.files import robot, world
from onika.model.camera import CameraBlock

EYES = """VERSION     2.0

CAMERA      above
AT          0 0 1
LOOKS       0.5 0 0
LENS        60
SIZE        640 480
RATE        5

CAMERA      side
VIEW        table.side

EOF
"""


def test_a_camera_stands_somewhere_or_is_one_of_the_model():  # R-F05, R-X19
    text, faults = world.read(EYES, "w", "f")
    assert faults == ()
    assert text.cameras == (
        CameraBlock("above", at=(0.0, 0.0, 1.0), looks=(0.5, 0.0, 0.0), lens=60.0, size=(640, 480), rate=5.0),
        CameraBlock("side", "table.side"),
    )
    assert world.write(text) == EYES


def test_a_camera_may_be_a_real_one():  # R-F05
    given = "VERSION     2.0\n\nCAMERA      usb\nDEVICE      /dev/video0\nLENS        70\nRATE        15\n\nEOF\n"
    text, faults = world.read(given, "w", "f")
    assert (faults, text.cameras) == ((), (CameraBlock("usb", device="/dev/video0", lens=70.0, rate=15.0),))
    assert world.write(text) == given


def test_a_robot_has_cameras_too():  # R-F05, R-X19
    eye = "CAMERA      eye\nON          hand\nAT          0 0 0\nLOOKS       0 0 1\n"
    given = f"VERSION     2.0\nFILE        a.xml\n\n{eye}\nEOF\n"
    text, faults = robot.read(given, "r", "f")
    assert (faults, text.cameras) == ((), (CameraBlock("eye", on="hand", at=(0.0,) * 3, looks=(0.0, 0.0, 1.0)),))
    assert robot.write(text) == given


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("SIZE        640 480", "SIZE 641 480", 7, "files.size_outside"),
        ("SIZE        640 480", "SIZE 640 15", 7, "files.size_outside"),
        ("SIZE        640 480", "SIZE 64.5 48", 7, "files.size_outside"),
        ("SIZE        640 480", "SIZE 640", 7, "files.meaning_after"),
        ("RATE        5", "RATE 31", 8, "files.value_outside"),
        ("RATE        5", "RATE 0", 8, "files.value_outside"),
        ("LENS        60", "LENS 180", 6, "files.value_outside"),
        ("AT          0 0 1\n", "", 4, "files.at_and_looks"),
        ("LOOKS       0.5 0 0\n", "", 4, "files.at_and_looks"),
        ("LOOKS       0.5 0 0", "LOOKS 0 0 1", 5, "files.looks_at_itself"),
        ("VIEW        table.side", "LENS 30", 11, "files.only_with_at"),
        ("CAMERA      side\n", "CAMERA above\n", 10, "files.name_twice"),
        ("AT          0 0 1", "VIEW top\nAT 0 0 1", 4, "files.view_or_at"),
        ("VIEW        table.side", "VIEW table.side\nDEVICE 0", 12, "files.real_camera_alone"),
        ("AT          0 0 1", "DEVICE 0\nAT 0 0 1", 4, "files.real_camera_alone"),
    ],
)
def test_what_is_wrong_with_a_camera_is_told_with_its_line(old, new, line, key):  # R-B07, R-F05
    text, faults = world.read(EYES.replace(old, new, 1), "w", "f")
    assert text is None
    assert (line, key) in [(fault.place.line, fault.reason.key) for fault in faults]
