import pytest

from kit.process.noted_process import NotedSupervisor
from onika.host.units import device_messages, device_server
from onika.host.units.device_servers import DEVICES, DeviceServers
from onika.ring.drive import DriveMode
from onika.words.reason import Reason


@pytest.fixture
def supervisor():
    return NotedSupervisor(device_server.__name__, device_messages.decode_order)


@pytest.fixture
def servers(supervisor):
    return DeviceServers(supervisor)


def modes_of(device):
    return {device: DriveMode.HELD}


def test_the_first_world_is_stepped_by_the_process_that_starts_with_the_runtime(servers, supervisor):  # R-E09, law 16
    assert list(supervisor.processes) == [DEVICES]
    assert servers.of("boxes") is supervisor.processes[DEVICES]
    assert list(supervisor.processes) == [DEVICES]


def test_every_further_world_has_a_process_of_its_own_that_is_called_after_it(servers, supervisor):  # R-E09, law 16
    servers.expect(["cell", "boxes@copy"])
    process = servers.of("boxes@copy")
    assert process is not servers.of("cell")
    assert servers.of("boxes@copy") is process
    assert str(process.title) == "the device server of boxes@copy"
    assert len(supervisor.processes) == 2
    assert all(servers.is_one(each) for each in supervisor.processes.values())


def test_an_order_goes_to_the_server_of_its_world_alone(servers):  # R-E09
    servers.expect(["cell", "boxes"])
    servers.send("boxes", device_messages.OpenWorld("boxes"), (7,))
    assert servers.of("boxes").orders == [(device_messages.OpenWorld("boxes"), 7)]
    assert servers.of("cell").orders == []


def test_the_answers_of_one_are_not_taken_for_those_of_another(servers):  # R-E09
    servers.expect(["cell", "boxes"])
    servers.answered(servers.of("boxes"), device_messages.PartTouched())
    assert (servers.has_answered("boxes"), servers.has_answered("cell")) == (True, False)
    assert servers.take_answer("boxes") == device_messages.PartTouched()
    assert not servers.has_answered("boxes")


@pytest.mark.parametrize("comes_late", [True, False])
def test_an_answer_that_nobody_waits_for_is_not_taken_for_that_to_the_next_question(servers, comes_late):  # R-X24
    servers.expect(["cell", "boxes"])
    late, own = device_messages.PartTouched(), device_messages.Denied(Reason.plain("no"))
    for step in (servers.give_up, lambda world: servers.answered(servers.of(world), late))[:: 1 if comes_late else -1]:
        step("boxes")
    assert not servers.has_answered("boxes")
    servers.answered(servers.of("cell"), own)
    servers.answered(servers.of("boxes"), own)
    assert servers.take_answer("boxes") == servers.take_answer("cell") == own


def test_a_stop_reaches_all_and_whoever_is_started_while_it_lasts(servers):  # law 27
    servers.expect(["cell", "boxes"])
    servers.stop()
    late = servers.of("late")
    assert [servers.of(world).kinds for world in ("cell", "boxes", "late")] == [["StopAll"]] * 3
    servers.allow_motion()
    assert late.kinds == ["StopAll", "AllowMotion"]
    assert servers.of("later").kinds == []


def test_how_all_drives_stand_is_answered_when_every_server_has_said_it(servers):  # R-E09
    told = []
    servers.expect(["cell", "boxes"])
    cell, boxes = servers.of("cell"), servers.of("boxes")
    servers.ask_modes(told.append)
    servers.ask_modes(told.append)
    servers.answered(cell, device_messages.ModesTaken(modes_of("cell:arm")))
    servers.answered(cell, device_messages.ModesTaken({}))
    assert told == []
    servers.answered(boxes, device_messages.ModesTaken(modes_of("boxes:arm")))
    assert told == [modes_of("cell:arm") | modes_of("boxes:arm")]
    servers.answered(boxes, device_messages.ModesTaken({}))
    assert told[1:] == [{}]


def test_with_one_lost_the_drives_of_the_others_hold_and_nobody_waits_for_it(servers):  # R-E10
    told = []
    servers.expect(["cell", "boxes"])
    servers.ask_modes(told.append)
    servers.of("boxes").is_lost = True
    servers.lose()
    assert servers.is_lost
    assert servers.of("cell").kinds == ["TakeModes", "StopAll"]
    assert told == [{}]
    servers.ask_modes(told.append)
    assert told == [{}, {}]
    assert servers.of("boxes").title == Reason.of("host.the_device_server_of", world="boxes")
