"""A lamp of a world from a file as a device: it publishes its switches, and shines while all of them are closed."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mujoco

from onika.model.world import LampBlock, SwitchBlock
from onika.ring.device import DeviceSheet, DriveState
from onika.workcell.composed.joint_facts import Unfit, absent
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit, row_of


class SwitchLamp(DeviceUnit):
    """A lamp, which takes no commands. Its switches are judged every 20 ms."""

    def __init__(self, lamp: LampBlock, switches: Mapping[str, SwitchBlock]) -> None:
        super().__init__(DeviceSheet(lamp.name, ("time", "drive", *lamp.when), (), {"WHEN": " ".join(lamp.when)}))
        self.lamp = lamp
        self._switches = tuple(switches[name] for name in lamp.when)
        self.state[1] = DriveState.DRIVEN  # it has no drive that could hold or trip
        self.flags = self.state[2:]

    def bind(self, plant: Plant) -> None:
        """Find sites and sensors in a new plant."""
        self._contacts = tuple(_contact(plant, switch) for switch in self._switches)

    @property
    def shining(self) -> Sequence[str]:
        """The shapes that are lit now."""
        return self.lamp.shines if self.flags.all() else ()

    def sense(self) -> None:
        """The switches as of the last step."""
        for number, contact in enumerate(self._contacts):
            self.flags[number] = 1.0 if contact.is_closed else 0.0

    def restart(self) -> None:
        """Dark."""
        self.flags[:] = 0.0


@dataclass(frozen=True, slots=True)
class _Contact:
    """A switch in one plant; its sensor and its sites, where it has such, as views of that."""

    force: Any
    least: float
    places: tuple[Any, ...]
    apart: float

    @property
    def is_closed(self) -> bool:
        if self.force is not None and self.force[0] <= self.least:
            return False
        return not self.places or math.dist(*self.places) <= self.apart


def _contact(plant: Plant, switch: SwitchBlock) -> _Contact:
    data, force = plant.data, switch.pressed
    at = None if force is None else int(plant.model.sensor(force[0]).adr[0])
    view = None if at is None else row_of(data.sensordata[at : at + 1])
    sites = switch.near[:2] if switch.near else ()
    places = tuple(row_of(data.site_xpos[plant.site(name)]) for name in sites)
    return _Contact(view, force[1] if force else 0.0, places, switch.near[2] if switch.near else 0.0)


def lacking_contact(model: Any, switch: SwitchBlock) -> Unfit | None:
    """What a switch names that its world does not have."""
    for site in switch.near[:2] if switch.near else ():
        if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, site) < 0:
            return absent(model, "NEAR", "site", model.nsite, site)
    if switch.pressed and mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, switch.pressed[0]) < 0:
        return absent(model, "PRESSED", "sensor", model.nsensor, switch.pressed[0])
    return None
