"""A stop in wall time goes straight to the processes: first to those of the devices, then to every unit (law 27)."""

import pytest

from onika.host.units import rtpu
from onika.host.units.unit_processes import UnitProcesses
from onika.host.units.wall import WallDriver
from onika.runtime import command


class NotedProcess:
    """A process that notes what it is sent, in one list with the others."""

    def __init__(self, name, sent):
        self.name, self._sent = name, sent
        self.is_up, self.is_lost = True, False
        self.post = self

    def send(self, payload):
        self._sent.append((self.name, payload))


class NotedSupervisor:
    """Starts nothing."""

    def __init__(self, sent):
        self._sent = sent
        self.with_fifo = False

    def launch(self, name, *_, **__):
        return NotedProcess(name, self._sent)


class NotedServers:
    """Device servers that note what all of them are told, in the same list."""

    def __init__(self, sent):
        self._sent = sent
        self.with_fifo = False

    def stop(self):
        self._sent.append(("devices", "stop"))

    def allow_motion(self):
        self._sent.append(("devices", "allow motion"))


@pytest.fixture
def sent():
    return []


@pytest.fixture
def driver(sent):
    """A driver whose processes were never started."""
    driver = WallDriver.__new__(WallDriver)
    driver._devices = NotedServers(sent)
    driver._units = UnitProcesses(NotedSupervisor(sent), ["rt1", "rt0"])
    return driver


def test_the_devices_hear_a_stop_before_every_unit_does(driver, sent):  # law 27
    driver.stop()
    stop = rtpu.encode(command.Stop())
    assert sent == [("devices", "stop"), ("rt0", stop), ("rt1", stop)]


def test_a_reset_reaches_the_devices_and_every_unit(driver, sent):  # law 27
    driver.reset()
    reset = rtpu.encode(command.Reset())
    assert sent == [("devices", "allow motion"), ("rt0", reset), ("rt1", reset)]
