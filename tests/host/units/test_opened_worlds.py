import pytest

from kit.worlds.box_cells import boxes_files
from onika.host.units.device_messages import (
    ClaimDevice,
    Denied,
    DisplacedTaken,
    FenceWriter,
    Granted,
    OpenWorld,
    PartTouched,
    ReleaseDevice,
    TakeDisplaced,
    TouchPart,
    WorldOpened,
)
from onika.host.units.opened_worlds import OpenedWorlds
from onika.runtime.command import DeviceGrant
from onika.words.reason import Reason

GRANT = DeviceGrant("bus:boxes", "arm_left", (), (), {}, 1, 0, None)
WHY = Reason.of("host.not_open")


class Servers:
    """Device servers that answer at once what they were told to answer; `sent` is what they were asked."""

    is_lost, is_up = False, True

    def __init__(self, *answers):
        self.sent, self._answers = [], [WorldOpened("boxes", True), *answers]

    def of(self, _world):
        return self

    def send(self, _world, order, _descriptors=()):
        self.sent.append(order)

    def has_answered(self, _world):
        return bool(self._answers)

    def take_answer(self, _world):
        return self._answers.pop(0)

    def give_up(self, world):
        self.sent.append(f"given up: {world}")


def wait(is_done, what, _patience_s):
    if not is_done():
        raise ValueError(what)


@pytest.fixture
def opened():
    """Worlds at servers with these answers, and the memory that was shared."""
    made = []

    def make(*answers):
        servers, shared = Servers(*answers), []
        worlds = OpenedWorlds(servers, wait, lambda name, _segment: shared.append(name))
        worlds.offer((boxes_files(),))
        made.append(worlds)
        return worlds, servers, shared

    yield make
    for worlds in made:
        worlds.close()


def test_a_world_is_opened_with_the_first_of_its_devices_and_once(opened):  # R-X19
    worlds, servers, shared = opened(Granted(GRANT), Granted(GRANT))
    assert worlds.names == ()
    assert worlds.grant("rt0", "boxes:arm_left") == worlds.grant("rt0", "boxes:arm_right") == GRANT
    assert [type(order) for order in servers.sent] == [OpenWorld, ClaimDevice, ClaimDevice]
    assert (worlds.names, worlds.simulated, shared) == (("boxes",), ("boxes",), ["bus:boxes"])


def test_what_is_denied_is_nobodys(opened):  # law 16
    worlds, servers, _ = opened(Denied(WHY))
    with pytest.raises(ValueError) as denied:
        worlds.grant("rt0", "boxes:arm_left")
    assert denied.value.args == (WHY,)
    worlds.fence("rt0")
    assert not any(isinstance(order, FenceWriter) for order in servers.sent)


def test_who_waits_in_vain_for_a_grant_has_it_fenced_should_it_come_late(opened):  # law 17
    worlds, servers, _ = opened()
    with pytest.raises(ValueError):
        worlds.grant("rt0", "boxes:arm_left")
    assert servers.sent[1:] == [ClaimDevice("boxes:arm_left", 1), "given up: boxes", FenceWriter(1)]


def test_of_a_unit_that_is_gone_the_writers_are_fenced_and_no_others(opened):  # law 17
    worlds, servers, _ = opened(Granted(GRANT), Granted(GRANT), Granted(GRANT))
    for unit, device in (("rt0", "boxes:arm_left"), ("rt1", "boxes:arm_right"), ("rt0", "boxes:gripper_left")):
        worlds.grant(unit, device)
    worlds.release("boxes:gripper_left")
    worlds.fence("rt0")
    assert servers.sent[-2:] == [ReleaseDevice("boxes:gripper_left", 3), FenceWriter(1)]


def test_a_world_that_is_not_open_is_not_touched(opened):
    worlds, servers, _ = opened()
    with pytest.raises(ValueError):
        worlds.touch("boxes", "panic", 1.0)
    assert servers.sent == []


def test_what_is_asked_of_all_worlds_is_nothing_where_a_server_is_lost(opened):
    worlds, servers, _ = opened(Granted(GRANT), PartTouched(), DisplacedTaken({"boxes": ()}))
    worlds.grant("rt0", "boxes:arm_left")
    worlds.touch("boxes", "panic", 1.0)
    assert worlds.displaced() == {"boxes": ()}
    assert servers.sent[-2:] == [TouchPart("boxes", "panic", 1.0), TakeDisplaced()]
    servers.is_lost = True
    assert worlds.displaced() == {}
