"""What is measured in a world from a file, as a device without commands: sensors of a model, or the pose of a body.

Numbers of sensors stand in a row, in their order in the block, as MuJoCo has them (SI, in the frame of their site). A
pose is x y z (m) and a quaternion w x y z, in the world.
"""

from collections.abc import Mapping
from typing import Any, ClassVar

import mujoco
import numpy as np

from onika.model.robot import Numbers, SensorBlock
from onika.ring.device import DeviceSheet, DriveState
from onika.workcell.composed.joint_facts import Unfit, absent
from onika.workcell.composed.robot_unit import EITHER, RobotUnit
from onika.workcell.plant import Plant

POSE = ("x", "y", "z", "qw", "qx", "qy", "qz")


def lacking(model: Any, sensor: SensorBlock, prefix: str = "") -> Unfit | None:
    """What a block names that its model does not have."""
    if sensor.body:
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, prefix + sensor.body)
        return absent(model, "POSE", "body", model.nbody, sensor.body) if body < 0 else None
    for name in sensor.reads:
        if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, prefix + name) < 0:
            return absent(model, "READS", "sensor", model.nsensor, name)
    return None


class SensorUnit(RobotUnit):
    """What is measured at a place, or in the world itself, of which robot and place are empty."""

    mode: ClassVar[str] = EITHER
    is_stopped: ClassVar[bool] = False

    def __init__(self, name: str, sensor: SensorBlock, model: Any, robot: str, place: str, prefix: str) -> None:
        self.sensor = sensor
        counts = [int(model.sensor(prefix + read).dim[0]) for read in sensor.reads]
        numbers = (f"{name}{k + 1}" for name, count in zip(sensor.reads, counts, strict=True) for k in range(count))
        state = ("time", "drive", *(POSE if sensor.body else numbers))
        identity: Mapping[str, Numbers | str] = {"MEASURES": sensor.body or " ".join(sensor.reads)}
        super().__init__(DeviceSheet(name, state, (), dict(identity)), robot, place, prefix, 0.0)
        self.state[1] = DriveState.DRIVEN  # it has no drive that could hold or trip

    def bind(self, plant: Plant) -> None:
        """Find its body or its sensors in a new plant."""
        self._plant = plant
        self._is_there = lacking(plant.model, self.sensor, self._prefix) is None
        if not self._is_there:
            return  # another robot stands where it was
        if self.sensor.body:
            self._body = plant.body(self._prefix + self.sensor.body)
            return
        found = [plant.model.sensor(self._prefix + name) for name in self.sensor.reads]
        self._rows = np.concatenate([int(row.adr[0]) + np.arange(int(row.dim[0])) for row in found])

    def refresh(self, time: float) -> None:
        """As of the last step; as it was, where it is not there."""
        state, data = self.state, self._plant.data
        state[0] = time
        if not self._is_there:
            return
        if self.sensor.body:
            state[2:5], state[5:9] = data.xpos[self._body], data.xquat[self._body]
        else:
            self._plant.measure(time)
            state[2:] = data.sensordata[self._rows]
