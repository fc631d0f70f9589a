"""A device of a robot from a file, at the place where the robot stands or may stand."""

from typing import ClassVar

from onika.ring.device import DeviceSheet
from onika.words.reason import Reason
from onika.workcell.unit import DeviceUnit

FORCELESS = "_kin"
"""Behind the name of a device that moves without forces."""

ANY = ""
"""The robot of a device that belongs to whichever stands at its place."""

EITHER = "*"
"""The mode of a device that is the same with forces and without."""


class RobotUnit(DeviceUnit):
    """What the devices of a robot have in common; `prefix` stands before the names of the robot's model."""

    mode: ClassVar[str] = ""
    """With forces, without them, or either."""
    is_stopped: ClassVar[bool] = True
    """Whether a panic button at its place stops it."""

    def __init__(self, sheet: DeviceSheet, robot: str, place: str, prefix: str, step_s: float) -> None:
        super().__init__(sheet, place)
        self.robot, self._prefix, self._step_s = robot, prefix, step_s

    @property
    def prefix(self) -> str:
        """What stands in the world before the names of its robot's model."""
        return self._prefix

    @property
    def may_run_on(self) -> bool:
        """Whether it ever does something in a step without being told to."""
        return False

    @property
    def runs_on(self) -> bool:
        """Whether what it follows goes on between two commands."""
        return False

    @property
    def is_away(self) -> bool:
        """Whether it does not stand as it began."""
        return False

    @property
    def away(self) -> Reason:
        """That it does not stand as it began, or where."""
        return Reason.of("workcell.arm_away", arm=Reason.of("workcell.named_robot", name=self.sheet.name))

    def run_on(self) -> None:
        """The signals of one step, where it runs on."""

    def move(self) -> None:
        """One step without forces."""

    def rest(self) -> None:
        """Stay where it is."""
