"""The panic button of an arm: pressed, its drive holds; let go, it has tripped and has to be cleared (§4.5.2)."""

from onika.ring.drive import DriveInput
from onika.words.reason import Reason
from onika.workcell.unit import DeviceUnit

PRESSED, LET_GO = 1.0, 0.0


class PanicButton:
    """A button that stays as it was put. `name` is what it is called in its world, `units` whose drives it stops.

    One without units is only felt: a switch that a hand touches.
    """

    takes = Reason.of("workcell.button_takes")

    def __init__(self, *units: DeviceUnit, name: str = "") -> None:
        self.name = name or f"panic_{units[0].side}"
        self.units = units
        self.is_pressed = False

    def put(self, value: float) -> DriveInput:
        """Press it (1) or let it go (0): what then happens to the drive. Raises ValueError for any other number."""
        if value not in (PRESSED, LET_GO):
            raise ValueError(Reason.of("workcell.button_value", takes=self.takes, button=self.name, value=value))
        self.is_pressed = value == PRESSED
        if self.is_pressed:
            return DriveInput.PRESS
        return DriveInput.LET_GO
