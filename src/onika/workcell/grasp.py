"""A hand without forces: fingers that slide at an even speed, and boxes that go with the hand (kinematic mode)."""

import numpy as np

from onika.laws import puma560
from onika.laws.frames import Array, inverse_pose
from onika.workcell.box import SIZE_M
from onika.workcell.gripper import CLOSED_M, FORCE_N, TRAVEL_M
from onika.workcell.part import STEP_S
from onika.workcell.pile import Pile
from onika.workcell.plant import Plant

JAWS_M = (0.050, 0.017, 0.020)
"""How far a box's middle may be from the point between the pads, along x, y and z of the hand, to be taken."""

ASKEW = 0.94
"""Cosine of how far a box may be turned against the hand to be taken: 20 degrees."""

FINGER_M_S = 0.2
"""Speed of a finger."""

_AT_BOX = (SIZE_M[0] - CLOSED_M) / 2  # where a finger stands that touches a box
_NEAR = 0.002  # how near a finger must be to that for a hand that is found closed to have the box


class Grasp:
    """One hand by name in one plant, and what it carries: boxes by number, and their poses in the frame of its tip."""

    def __init__(self, plant: Plant, name: str, pile: Pile) -> None:
        self.name = name
        fingers, valves, pads = ([f"{name}.{part}{k}" for k in (1, 2)] for part in ("finger", "valve", "touch"))
        where, rate = plant.joints(fingers)
        self._q, self._qd = plant.data.qpos[where], plant.data.qvel[rate]
        self._signal = plant.data.ctrl[plant.signals(valves)]
        self._pads = plant.data.sensordata[plant.sensors(pads)]
        hand = plant.body(f"{name}.hand")
        self._place, self._turn = plant.data.xpos[hand], plant.data.xmat[hand].reshape(3, 3)
        self._pile = pile
        self.carried: dict[int, Array] = {}

    def take_up(self) -> None:
        """A hand that is found closed on a box has it."""
        if self._signal[0] < 0.0 and abs(float(self._q[0]) - _AT_BOX) < _NEAR:
            self._take()

    def move(self) -> None:
        """Fingers one step on; a box that is let go falls, one that is met on closing is taken."""
        q = float(self._q[0])
        if self._signal[0] > 0.0:
            self._let_go()
            wanted = min(q + FINGER_M_S * STEP_S, TRAVEL_M)
        else:
            wanted = max(q - FINGER_M_S * STEP_S, 0.0)
            if self.carried or (wanted <= _AT_BOX <= q and self._take()):
                wanted = _AT_BOX
        self._q[:] = wanted
        self._qd[:] = (wanted - q) / STEP_S

    def carry(self) -> None:
        """Put what it carries where the hand has come to."""
        tip = self._tip()
        for number, pose in self.carried.items():
            self._pile.put(number, tip @ pose)

    def feel(self) -> None:
        """Press the pads."""
        self._pads[:] = FORCE_N if self.carried else 0.0

    def _tip(self) -> Array:
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = self._turn, self._place
        tip: Array = pose @ puma560.TOOL
        return tip

    def _take(self) -> bool:
        """Take the nearest box between the jaws, squared and centred as they do it, with all that stands on it."""
        tip = inverse_pose(self._tip())
        seen = {number: tip @ self._pile.pose(number) for number in self._pile.lying()}
        between = [number for number, pose in seen.items() if _is_between(pose)]
        if not between:
            return False
        number = min(between, key=lambda body: float(np.linalg.norm(seen[body][:3, 3])))
        square = seen[number].copy()
        square[:3, :3] = np.rint(square[:3, :3])
        square[1, 3] = 0.0
        moved = square @ inverse_pose(seen[number])
        self.carried = {box: moved @ seen[box] for box in (number, *self._pile.standing_on(number))}
        self._pile.held |= set(self.carried)
        return True

    def _let_go(self) -> None:
        self._pile.drop(self.carried)
        self.carried = {}


def _is_between(pose: Array) -> bool:
    """Whether a box at this pose in the frame of the tip can be taken: near, its short side across, upright."""
    near = all(abs(pose[k, 3]) <= JAWS_M[k] for k in range(3))
    return near and abs(pose[1, 0]) >= ASKEW and abs(pose[2, 2]) >= ASKEW
