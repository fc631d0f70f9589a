"""What whoever looks sees of worlds in other processes: asked once, then told; forgotten when nobody looks."""

import pytest

from onika.host.units import device_messages
from onika.host.units.pose_stream import WorldPoses
from onika.host.units.served_views import ServedViews
from onika.words.reason import Reason

EYE = "yard:eye"


class Devices:
    """Notes what is sent."""

    def __init__(self):
        self.is_lost = False
        self.sent = []

    def send(self, world, order, descriptors=()):
        self.sent.append((order, descriptors))


class Server:
    """Answers one question about a world, or says why not."""

    def __init__(self, answer):
        self.answer = answer
        self.devices = Devices()
        self.views = ServedViews(self.devices, {"yard": ""}, self.ask)

    def ask(self, world, order):
        if isinstance(self.answer, ValueError):
            raise self.answer
        return self.answer


@pytest.fixture
def server():
    return Server(device_messages.WorldDescribed({"shapes": []}))


def test_a_scene_is_what_the_server_answers(server):  # R-D13
    assert server.views.scene("yard") == {"shapes": []}


def test_there_is_no_scene_of_a_world_that_is_shut_or_whose_server_is_gone_or_fails(server):
    assert server.views.scene("elsewhere") is None
    server.answer = ValueError(Reason.plain("it is gone"))
    assert server.views.scene("yard") is None
    server.answer = device_messages.Denied(Reason.plain("not now"))
    assert server.views.scene("yard") is None
    server.devices.is_lost = True
    server.answer = device_messages.WorldDescribed({})
    assert server.views.scene("yard") is None


def test_poses_are_asked_for_once_and_are_those_that_were_said_last(server):
    assert server.views.poses("yard") is None
    server.views.take(WorldPoses("yard", 7, b"rows", ("lamp",)))
    server.views.take(WorldPoses("yard", 8, b"others", ()))
    assert server.views.poses("yard") == (8, b"others", ())
    assert server.devices.sent == [(device_messages.StreamPoses("yard"), ())]
    assert server.views.poses("elsewhere") is None


def test_poses_are_said_at_another_socket_too(server):
    server.views.pose_to("yard", 5)
    assert server.devices.sent == [(device_messages.StreamPoses("yard"), (5,))]


def test_a_camera_is_shown_while_somebody_looks_and_its_picture_is_forgotten_afterwards(server):  # R-F05
    assert server.views.picture(EYE) is None
    server.views.take(device_messages.PictureTaken("yard", "eye", 3, 11, b"jpeg"))
    assert server.views.picture(EYE) == (3, 11, b"jpeg")
    server.views.look_only_at([EYE])
    assert server.views.picture(EYE) == (3, 11, b"jpeg"), "somebody still looks"
    server.views.look_only_at([])
    shown = [order for order, _ in server.devices.sent]
    assert shown == [device_messages.ShowCamera("yard", "eye", True), device_messages.ShowCamera("yard", "eye", False)]
    assert server.views.picture(EYE) is None
