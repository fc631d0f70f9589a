"""The lamp as a device: it only publishes which contacts of its circuit are closed."""

from onika.ring.device import DeviceSheet, DriveState
from onika.workcell.box import SIGNS
from onika.workcell.circuit import CONTACTS, Circuit
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit


class LampUnit(DeviceUnit):
    """The lamp, which only publishes: the six contacts of its circuit, judged every 10 ms."""

    def __init__(self) -> None:
        names = tuple(f"contact{k}" for k in range(1, CONTACTS + 1))
        super().__init__(DeviceSheet("lamp", ("time", "drive", *names), (), {"BOXES": " ".join(SIGNS)}))
        self.state[1] = DriveState.DRIVEN  # it has no drive that could hold or trip
        self.flags = self.state[2:]
        self._circuit: Circuit

    def bind(self, plant: Plant) -> None:
        """Find the circuit in a new plant."""
        self._circuit = Circuit(plant)

    @property
    def lit(self) -> bool:
        """Whether all contacts are closed."""
        return bool(self.flags.all())

    def sense(self) -> None:
        """The contacts of the last step."""
        self._circuit.scan(self.flags)

    def restart(self) -> None:
        """Dark."""
        self.flags[:] = 0.0
