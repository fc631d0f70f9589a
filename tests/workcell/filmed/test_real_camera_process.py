"""A real camera is the same device as one that is rendered: a row of pictures stands for it, read by OpenCV."""

import sys
from time import monotonic_ns

import numpy as np
import pytest
from PIL import Image

from kit.worlds.filmed_cells import filmed
from onika.workcell.filmed.filmed_world import FilmedWorld

STEP_NS = 5_000_000
SIZE = (32, 24)
STUB = """
import os
import numpy as np
from PIL import Image

CAP_PROP_FRAME_WIDTH = CAP_PROP_FRAME_HEIGHT = CAP_PROP_BUFFERSIZE = INTER_AREA = 0


class VideoCapture:
    def __init__(self, source):
        self.source, self.number = source, 0

    def isOpened(self):
        return isinstance(self.source, str) and os.path.exists(self.source % 0)

    def set(self, what, value):
        pass

    def read(self):
        path = self.source % self.number
        self.number += 1
        if not os.path.exists(path):
            return False, None
        return True, np.asarray(Image.open(path))[:, :, ::-1]

    def release(self):
        pass


def resize(picture, size, interpolation):
    return np.asarray(Image.fromarray(np.ascontiguousarray(picture)).resize(size))
"""


def block(source, rate=20):
    return f"CAMERA real\nDEVICE {source}\nLENS 60\nSIZE {SIZE[0]} {SIZE[1]}\nRATE {rate}\n"


@pytest.fixture
def pictures(tmp_path):
    """Three pictures: red, green, blue, twice as large as they are wanted."""
    for number in range(3):
        pixels = np.zeros((2 * SIZE[1], 2 * SIZE[0], 3), dtype=np.uint8)
        pixels[:, :, number] = 200
        Image.fromarray(pixels).save(tmp_path / f"frame_{number:02d}.png")
    return f"{tmp_path}/frame_%02d.png"


@pytest.fixture(params=["stub", "opencv"])
def opencv(request, tmp_path, monkeypatch):
    """What stands for OpenCV where it is not installed, and the real one where it is."""
    if request.param == "opencv":
        return pytest.importorskip("cv2", reason="OpenCV is not installed")
    (tmp_path / "stub").mkdir()
    (tmp_path / "stub" / "cv2.py").write_text(STUB)
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path / 'stub'}:{':'.join(filter(None, sys.path))}")
    return None


def in_step(source):
    world = FilmedWorld(filmed(block(source)))
    world.render_in_step()
    world.look("real", True)
    return world


def beside_the_clock(world, is_done, patience_s=20.0):
    """Let the world go on beside the clock until something is so; how long the longest step took (ns)."""
    began, longest = monotonic_ns(), 0
    while not is_done():
        if monotonic_ns() - began > patience_s * 1e9:
            pytest.fail("nothing came")
        before = monotonic_ns()
        world.step(before - began)
        longest = max(longest, monotonic_ns() - before)
    return longest


def test_a_row_of_pictures_comes_one_by_one_in_the_size_that_is_wanted_and_its_end_is_told(opencv, pictures):  # R-F05
    world = in_step(pictures)
    colours = []
    for taken_ns in (0, 50_000_000, 100_000_000):
        world.step(taken_ns + STEP_NS)
        colours.append(int(world.picture("real")[12, 16].argmax()))
    assert (colours, world.picture("real").shape) == ([0, 1, 2], (SIZE[1], SIZE[0], 3))
    assert world.state("real")[2] == 3
    assert world.take_events() == []
    world.step(150_000_000 + STEP_NS)
    assert [(event.device, event.cause.key) for event in world.take_events()] == [("real", "workcell.camera_gone")]
    world.look("real", False)


def test_what_is_shown_comes_in_a_small_form_and_no_step_waits_for_it(opencv, pictures):  # R-F05, R-F08
    world = FilmedWorld(filmed(block(pictures)))
    world.show("real", True)
    small = {}

    def is_done():
        small.update(world.take_small())
        return bool(small)

    beside_the_clock(world, is_done)
    assert small["real"][2][:4] in (b"\x89PNG", b"\xff\xd8\xff\xe0")
    world.show("real", False)


def test_a_camera_that_is_not_there_is_told_and_the_world_goes_on(opencv):  # R-F05
    world = FilmedWorld(filmed(block("/nowhere/frame_%02d.png")))
    world.look("real", True)
    events = []
    beside_the_clock(world, lambda: events.extend(world.take_events()) or events)
    assert [event.cause.key for event in events] == ["workcell.camera_not_open"]
    assert world.state("real")[2:].tolist() == [0.0, 0.0]


def test_in_virtual_time_a_real_camera_is_not_opened():  # R-F05, law 15
    world = in_step("0")
    (event,) = world.take_events()
    assert event.cause.key == "workcell.camera_out_of_time"


def test_without_opencv_what_to_install_is_told(tmp_path, monkeypatch):  # R-F05
    (tmp_path / "cv2.py").write_text("raise ImportError('none here')")
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:{':'.join(filter(None, sys.path))}")
    world = in_step("film.mp4")
    world.step(50_000_000)
    (event,) = world.take_events()
    assert event.cause.key == "workcell.no_opencv"


def test_it_says_of_itself_what_any_camera_says():  # R-F05
    world = FilmedWorld(filmed(block("0", rate=5)))
    (sheet,) = [sheet for sheet in world.devices() if sheet.name == "real"]
    assert (sheet.identity["W"], sheet.identity["RATE"], sheet.picture) == ((32.0,), (5.0,), (24, 32))
    assert sheet.identity["FOCAL"] == pytest.approx((12.0 / np.tan(np.pi / 6),))
