"""What moves a world without forces in place of physics: arms go where they are told, boxes with the hands (law 18).

Nothing collides and nothing topples. Everything else, from devices to pictures, is as in the physical world.
"""

from collections.abc import Iterable
from typing import Any

import mujoco

from onika.workcell.box import SIGNS
from onika.workcell.circuit import Circuit
from onika.workcell.grasp import Grasp
from onika.workcell.kinematic_unit import KinematicUnit
from onika.workcell.pile import Pile
from onika.workcell.plant import Plant


class Kinematics:
    """The kinematic mode of one plant, with the arms in it and their hands by name.

    Taking over a world, it stops everything, lets hands keep what they hold, and lays down what hangs in the air.
    """

    def __init__(self, plant: Plant, arms: Iterable[KinematicUnit], hands: Iterable[str]) -> None:
        self._arms = tuple(arms)
        self._pile, self._circuit = Pile(plant), Circuit(plant)
        self._hands = tuple(Grasp(plant, hand, self._pile) for hand in hands)
        plant.data.qvel[:] = 0.0
        mujoco.mj_kinematics(plant.model, plant.data)
        for hand in self._hands:
            hand.take_up()
        self._pile.drop(self._pile.lying())

    def step(self, model: Any, data: Any) -> None:
        """One step, as MuJoCo's own."""
        for arm in self._arms:
            arm.move()
        mujoco.mj_kinematics(model, data)
        for hand in self._hands:
            hand.move()
        if self._pile.held:
            for hand in self._hands:
                hand.carry()
        mujoco.mj_kinematics(model, data)

    def carried(self, side: str) -> tuple[str, ...]:
        """The signs of the boxes in the hand of a side."""
        hand = next(hand for hand in self._hands if hand.name.endswith(f"_{side}"))
        return tuple(SIGNS[number] for number in hand.carried)

    def feel(self) -> None:
        """Press the sensors of pads and patches, as `Plant.sense` does where there are forces."""
        for hand in self._hands:
            hand.feel()
        self._circuit.press()
