"""A lamp of a world from a file as a device: it publishes its switches, and shines while all of them are closed."""

import math
from collections.abc import Mapping, Sequence

from onika.model.world import LampBlock, SwitchBlock
from onika.ring.device import DeviceSheet, DriveState
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit


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
        self._plant = plant

    @property
    def shining(self) -> Sequence[str]:
        """The shapes that are lit now."""
        return self.lamp.shines if self.flags.all() else ()

    def sense(self) -> None:
        """The switches as of the last step."""
        for number, switch in enumerate(self._switches):
            self.flags[number] = 1.0 if self._is_closed(switch) else 0.0

    def restart(self) -> None:
        """Dark."""
        self.flags[:] = 0.0

    def _is_closed(self, switch: SwitchBlock) -> bool:
        data = self._plant.data
        if switch.pressed is not None and data.sensor(switch.pressed[0]).data[0] <= switch.pressed[1]:
            return False
        if switch.near is None:
            return True
        first, other, apart = switch.near
        return math.dist(data.site(first).xpos, data.site(other).xpos) <= apart
