"""Pictures on the bus of a world."""

import numpy as np
import pytest

from onika.ring.device import DeviceSheet
from onika.ring.segment import Segment
from onika.ring.slots import Ring
from onika.runtime.bus import SEGMENT_SIZE, Bus
from onika.runtime.device import Device
from onika.runtime.modules.binding import attach
from onika.runtime.picture import picture_size

SIZE = (4, 6)


class Eyes:
    """A world with two cameras and a scale."""

    step_ns = 1

    def __init__(self):
        self.now_ns = 0
        self.wanted = []
        self.states = {name: np.zeros(4) for name in ("left", "right", "scale")}
        self.pixels = {name: np.zeros((*SIZE, 3), np.uint8) for name in ("left", "right")}

    def devices(self):
        cameras = [
            DeviceSheet(name, ("time", "drive", "number", "age"), (), {"RATE": (10.0,)}, SIZE)
            for name in ("left", "right")
        ]
        return (*cameras, DeviceSheet("scale", ("time", "drive", "a", "b"), (), {}))

    def state(self, device):
        return self.states[device]

    def picture(self, device):
        return self.pixels[device]

    def look(self, device, is_wanted):
        self.wanted.append((device, is_wanted))

    def show(self, device, is_shown):
        self.wanted.append((device, f"shown {is_shown}"))

    def take_small(self):
        return {"left": (1, 5, b"file")}

    def release(self, device, epoch):
        pass

    def step(self, until_ns):
        self.now_ns = until_ns

    def take(self, device, grey):
        self.pixels[device][:] = grey
        self.states[device][2] += 1


@pytest.fixture
def segment():
    segment = Segment.create("test", SEGMENT_SIZE)
    yield segment
    segment.close()


def test_a_task_sees_the_newest_picture_and_the_same_array_each_time(segment):  # R-F05
    world = Eyes()
    bus = Bus("w", world, segment)
    device = attach(bus.grant("right", 1), {"bus:w": segment.view})
    assert not device.picture().any()
    world.take("right", 7)
    world.take("left", 9)
    bus.step(1)
    picture = device.picture()
    assert picture.shape == (*SIZE, 3)
    assert (picture == 7).all()
    assert device.read()[0] == 1
    world.pixels["right"][:] = 8  # half of a picture that is not counted yet
    bus.step(2)
    assert (device.picture() == 7).all()
    assert device.picture() is picture
    with pytest.raises(ValueError, match="read-only"):
        picture[0] = 1


def test_a_camera_is_wanted_from_its_first_user_to_its_last(segment):  # R-F05
    world = Eyes()
    bus = Bus("w", world, segment)
    bus.grant("left", 1)
    bus.grant("left", 2)
    bus.grant("scale", 3)
    bus.release("left", 0)
    assert world.wanted == [("left", True)]
    bus.release("left", 0)
    bus.release("left", 0)
    bus.release("scale", 3)
    assert world.wanted == [("left", True), ("left", False)]
    again = bus.grant("left", 4)
    assert world.wanted[-1] == ("left", True)
    assert again.picture == SIZE


def test_pictures_lie_behind_the_states_and_beside_each_other(segment):  # law 16
    bus = Bus("w", Eyes(), segment)
    grants = [bus.grant(name, number) for number, name in enumerate(("left", "right", "scale"), 1)]
    state, nothing = Ring.footprint(8 * 4), Ring.footprint(8 * 2)
    assert [grant.state_offset for grant in grants] == [0, state + nothing, 2 * (state + nothing)]
    end = 3 * (state + nothing)
    assert [grant.picture_offset for grant in grants] == [end, end + Ring.footprint(picture_size(SIZE)), 0]


def test_what_is_no_camera_takes_no_pictures(segment):
    device = attach(Bus("w", Eyes(), segment).grant("scale", 1), {"bus:w": segment.view})
    assert isinstance(device, Device)
    with pytest.raises(ValueError, match="scale is no camera"):
        device.picture()


def test_somebody_looks_at_cameras_beside_the_tasks(segment):  # R-F08
    world = Eyes()
    bus = Bus("w", world, segment)
    assert bus.take_small() == {}
    bus.show("left", True)
    bus.show("scale", True)
    bus.show("nothing", True)
    assert bus.take_small() == {"left": (1, 5, b"file")}
    bus.show("left", False)
    assert bus.take_small() == {}
    assert world.wanted == [("left", "shown True"), ("left", "shown False")]


def test_a_scene_names_its_cameras(segment):  # R-F08
    world = Eyes()
    world.scene, world.parts = tuple, dict
    (left, right) = Bus("w", world, segment).scene()["cameras"]
    assert left == {"name": "left", "width": 6, "height": 4, "rate": 10.0}
    assert right["name"] == "right"
