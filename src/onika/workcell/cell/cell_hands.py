"""The grippers of a world from files that arms bear, and what is in them, as it stands now."""

from collections.abc import Mapping, Sequence
from functools import cached_property

from onika.model.world import PartBlock
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.robot_unit import RobotUnit
from onika.workcell.gripping.finger_way import FingerWay
from onika.workcell.gripping.forceless import Forceless
from onika.workcell.gripping.grasp import Grasp
from onika.workcell.gripping.loose_parts import LooseParts
from onika.workcell.gripping.tool_frame import ToolFrame
from onika.workcell.plant import Plant


class CellHands:
    """Those among these devices, in one plant; which way their fingers go is tried when it is first asked."""

    def __init__(
        self,
        plant: Plant,
        robots: Sequence[RobotUnit],
        arms: Mapping[JointUnit, bool],
        parts: Sequence[PartBlock],
        step_s: float,
    ) -> None:
        self._plant, self._parts, self._step_s = plant, parts, step_s
        self._arms = {unit.side: unit for unit in reversed([*arms])}
        self._grippers = [unit for unit in robots if isinstance(unit, FingerUnit) and unit.side in self._arms]

    @cached_property
    def ways(self) -> dict[FingerUnit, tuple[FingerWay, ToolFrame]]:
        """Each with the way of its fingers and the tool of the arm that bears it."""
        tools = {unit: ToolFrame(self._plant, self._arms[unit.side]) for unit in self._grippers}
        return {unit: (FingerWay(self._plant, unit, tool), tool) for unit, tool in tools.items()}

    def held(self, arm: JointUnit, forceless: Forceless | None) -> str | None:
        """The part in the hand of an arm, by its name; `forceless` moves the world where there are no forces."""
        unit = next((unit for unit in self._grippers if unit.side == arm.side), None)
        if unit is None:
            return None
        if forceless is not None:
            return next(iter(forceless.carried(unit)), None)
        if unit.aim >= unit.facts.gripper.open[1]:
            return None
        parts = LooseParts(self._plant, self._parts)
        held = Grasp(unit, *self.ways[unit], parts, self._step_s).holds()
        return None if held is None else parts.names[held]
