"""Worlds in a recording: what they consist of once, then where everything is (law 29)."""

import pytest

from onika.host.recording.recorded_worlds import RecordedWorlds
from onika.host.recording.recording_sink import AddScene
from onika.host.units.pose_stream import WorldPoses

SHAPES = ({"name": "lamp"},)


class Seen:
    """One world, which opens late."""

    def __init__(self):
        self.worlds = ("yard",)
        self.views = self
        self.opened = None
        self.asked = []

    def scene(self, world):
        return self.opened

    def poses(self, world):
        return (1, ((0.0,) * 7,), ("lamp",), 0)

    def pose_to(self, world, inlet):
        self.asked.append((world, inlet))


class Pen:
    """Notes what it is to write; with an inlet it hears poses itself."""

    def __init__(self, inlet=None):
        self.inlet = inlet
        self.orders = []

    def take(self, order, segment=None):
        self.orders.append(order)


@pytest.fixture
def seen():
    return Seen()


def test_a_world_is_shown_once_and_its_poses_thirty_times_a_second(seen):  # law 29
    seen.opened = {"shapes": SHAPES}
    pen, worlds = Pen(), RecordedWorlds(seen)
    for at in range(0, 100_000_000, 1_000_000):
        worlds.show(pen, at)
    scenes = [order for order in pen.orders if isinstance(order, AddScene)]
    poses = [order for order in pen.orders if isinstance(order, WorldPoses)]
    assert scenes == [AddScene("yard", SHAPES)]
    assert [order.at_ns for order in poses] == [0, 33_000_000, 66_000_000, 99_000_000]


def test_a_world_that_cannot_say_yet_what_it_is_made_of_is_asked_again(seen):  # law 29
    pen, worlds = Pen(), RecordedWorlds(seen)
    worlds.show(pen, 0)
    assert pen.orders == []
    seen.opened = {"shapes": SHAPES}
    worlds.show(pen, 1)
    assert pen.orders[0] == AddScene("yard", SHAPES)


def test_who_writes_elsewhere_hears_the_poses_there(seen):  # law 29
    seen.opened = {"shapes": SHAPES}
    pen = Pen(inlet=7)
    RecordedWorlds(seen).show(pen, 0)
    assert (seen.asked, len(pen.orders)) == ([("yard", 7)], 1)
