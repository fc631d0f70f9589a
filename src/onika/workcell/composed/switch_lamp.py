"""A lamp of a world from a file as a device: it publishes its switches, and shines while all of them are closed."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mujoco

from onika.model.world import LampBlock, SwitchBlock
from onika.ring.device import DeviceSheet, DriveState
from onika.words.reason import Reason
from onika.workcell.composed.joint_facts import Unfit, absent
from onika.workcell.panic_button import PanicButton
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit, row_of


class SwitchLamp(DeviceUnit):
    """A lamp, which takes no commands. Its switches are judged every 20 ms."""

    def __init__(
        self, lamp: LampBlock, switches: Mapping[str, SwitchBlock], touched: Mapping[str, PanicButton]
    ) -> None:
        super().__init__(DeviceSheet(lamp.name, ("time", "drive", *lamp.when), (), {"WHEN": " ".join(lamp.when)}))
        self.lamp = lamp
        self._switches = tuple(switches[name] for name in lamp.when)
        self.measures = any(switch.above for switch in self._switches)
        self._touched = touched
        self.state[1] = DriveState.DRIVEN  # it has no drive that could hold or trip
        self.flags = self.state[2:]

    def bind(self, plant: Plant) -> None:
        """Find sites and sensors in a new plant."""
        self._plant = plant
        self._contacts = tuple(_contact(plant, switch, self._touched.get(switch.name)) for switch in self._switches)

    @property
    def shining(self) -> Sequence[str]:
        """The shapes that are lit now."""
        return self.lamp.shines if self.flags.all() else ()

    def sense(self) -> None:
        """The switches as of the last step."""
        closed = [contact.is_closed for contact in self._contacts]  # touch sensors before all others are measured
        if self.measures:
            self._plant.measure(float(self._plant.data.time))
        for number, contact in enumerate(self._contacts):
            self.flags[number] = 1.0 if closed[number] and contact.is_above else 0.0

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
    number: Any = None
    bound: float = 0.0
    touched: PanicButton | None = None

    @property
    def is_above(self) -> bool:
        """What it says of a number that is measured."""
        return self.number is None or bool(self.number[0] > self.bound)

    @property
    def is_closed(self) -> bool:
        """What else it says."""
        if self.touched is not None and not self.touched.is_pressed:
            return False
        if self.force is not None and self.force[0] <= self.least:
            return False
        return not self.places or math.dist(*self.places) <= self.apart


def _contact(plant: Plant, switch: SwitchBlock, touched: PanicButton | None) -> _Contact:
    data, force, above = plant.data, switch.pressed, switch.above
    view = None if force is None else _number(plant, force[0])
    number = None if above is None else _number(plant, above[0], above[2])
    sites = switch.near[:2] if switch.near else ()
    places = tuple(row_of(data.site_xpos[plant.site(name)]) for name in sites)
    least, apart = force[1] if force else 0.0, switch.near[2] if switch.near else 0.0
    return _Contact(view, least, places, apart, number, above[1] if above else 0.0, touched)


def _number(plant: Plant, sensor: str, place: int = 0) -> Any:
    """One number of a sensor, as a view."""
    at = int(plant.model.sensor(sensor).adr[0]) + place
    return row_of(plant.data.sensordata[at : at + 1])


def lacking_contact(model: Any, switch: SwitchBlock) -> Unfit | None:
    """What a switch names that its world does not have."""
    for site in switch.near[:2] if switch.near else ():
        if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, site) < 0:
            return absent(model, "NEAR", "site", model.nsite, site)
    if switch.pressed and mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, switch.pressed[0]) < 0:
        return absent(model, "PRESSED", "sensor", model.nsensor, switch.pressed[0])
    return _lacking_number(model, *switch.above) if switch.above else None


def _lacking_number(model: Any, sensor: str, _bound: float, place: int) -> Unfit | None:
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, sensor) < 0:
        return absent(model, "ABOVE", "sensor", model.nsensor, sensor)
    count = int(model.sensor(sensor).dim[0])
    if place < count:
        return None
    return Unfit("ABOVE", Reason.of("workcell.sensor_number", count=count, sensor=sensor, found=place))
