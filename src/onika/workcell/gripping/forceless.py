"""What moves a world from files without forces, in place of physics: joints go where they are told, parts with hands.

Nothing collides and nothing topples (law 18). Everything else, from devices to pictures, is as with forces.
"""

from collections.abc import Iterable, Mapping
from typing import Any

import mujoco

from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.robot_unit import RobotUnit
from onika.workcell.gripping.finger_way import FingerWay
from onika.workcell.gripping.grasp import Grasp
from onika.workcell.gripping.loose_parts import LooseParts
from onika.workcell.gripping.stillness import Stillness
from onika.workcell.gripping.tool_frame import ToolFrame
from onika.workcell.plant import Plant


class Forceless:
    """One plant without forces, with what stands in it.

    Taking over a world, it stops everything, lets hands keep what they hold, and lays down what hangs in the air.
    """

    def __init__(
        self,
        plant: Plant,
        units: Iterable[RobotUnit],
        parts: LooseParts,
        hands: Mapping[FingerUnit, tuple[FingerWay, ToolFrame]],
        step_s: float,
    ) -> None:
        self._units, self._parts = tuple(units), parts
        plant.data.qvel[:] = 0.0
        mujoco.mj_kinematics(plant.model, plant.data)
        self.hands = tuple(Grasp(unit, way, tool, parts, step_s) for unit, (way, tool) in hands.items())
        self._stillness = Stillness(plant, {at for unit in hands for at in unit.felt_at})
        for hand in self.hands:
            hand.take_up()
            hand.unit.moved_by = hand
        parts.drop(parts.lying())
        mujoco.mj_kinematics(plant.model, plant.data)

    def step(self, model: Any, data: Any) -> None:
        """One step, as MuJoCo's own."""
        for unit in self._units:
            unit.move()
        mujoco.mj_kinematics(model, data)
        for hand in self.hands:
            hand.move()
        for hand in self.hands:
            hand.carry()
        mujoco.mj_kinematics(model, data)

    def feel(self) -> None:
        """Press sensors, as `Plant.sense` does where there are forces."""
        self._stillness.feel()

    def carried(self, unit: FingerUnit) -> tuple[str, ...]:
        """The parts in a hand, by name."""
        hand = next((hand for hand in self.hands if hand.unit is unit), None)
        return tuple(self._parts.names[number] for number in hand.carried) if hand else ()
