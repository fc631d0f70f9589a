"""A compiled world: MuJoCo's model and data with its names, able to take over the state of another one by name."""

from collections.abc import Callable, Mapping

import mujoco
import numpy as np
import numpy.typing as npt

FACTORS = ("friction", "mass")
"""What of a world may be otherwise than its model says."""
_FEELING, _NUMB = 0, int(mujoco.mjtDisableBit.mjDSBL_SENSOR)


class Plant:
    """One model and its data. Arrays handed out are views that live as long as the plant."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self.model = model
        self.data = mujoco.MjData(self.model)
        self._option = self.model.opt
        self._measured_at = -1.0
        self._is_varied = False

    def body(self, name: str) -> int:
        """Number of a body; raises KeyError for an unknown name."""
        return int(self.model.body(name).id)

    def site(self, name: str) -> int:
        """Number of a marked place; raises KeyError for an unknown name."""
        return int(self.model.site(name).id)

    def joints(self, names: list[str]) -> tuple[slice, slice]:
        """Where neighbouring hinges and slides stand in qpos and in qvel."""
        first = self.model.joint(names[0])
        q, v = int(first.qposadr[0]), int(first.dofadr[0])
        return slice(q, q + len(names)), slice(v, v + len(names))

    def signals(self, names: list[str]) -> slice:
        """Where neighbouring actuators stand in ctrl."""
        first = int(self.model.actuator(names[0]).id)
        return slice(first, first + len(names))

    def vary(self, factors: Mapping[str, float]) -> None:
        """Once: how much it rubs, and what weighs that is free to move, by these factors (`FACTORS`)."""
        if self._is_varied or not factors:
            return
        self._is_varied = True
        model = self.model
        model.geom_friction[:, 0] *= factors.get("friction", 1.0)
        model.pair_friction[:, :2] *= factors.get("friction", 1.0)
        free = {int(model.jnt_bodyid[k]) for k in range(model.njnt) if model.jnt_type[k] == mujoco.mjtJoint.mjJNT_FREE}
        loose = [body for body in range(model.nbody) if int(model.body_rootid[body]) in free]
        model.body_mass[loose] *= factors.get("mass", 1.0)
        model.body_inertia[loose] *= factors.get("mass", 1.0)
        mujoco.mj_setConst(model, mujoco.MjData(model))

    def take(self, other: "Plant", is_other: Callable[[str], bool] = lambda _name: False) -> None:
        """Take over positions, speeds and signals of everything that has the same name in `other`.

        is_other    whether what is called so is another thing there
        """
        for k in range(self.model.njnt):
            name = self.model.joint(k).name
            if is_other(name):
                continue
            there = mujoco.mj_name2id(other.model, mujoco.mjtObj.mjOBJ_JOINT, name)
            if there >= 0 and self.model.jnt_type[k] == other.model.jnt_type[there]:
                mine, theirs = self.data.joint(name), other.data.joint(name)
                mine.qpos[:], mine.qvel[:] = theirs.qpos, theirs.qvel
                mine.qacc_warmstart[:] = theirs.qacc_warmstart
        for k in range(self.model.nu):
            name = self.model.actuator(k).name
            there = mujoco.mj_name2id(other.model, mujoco.mjtObj.mjOBJ_ACTUATOR, name)
            if there >= 0 and not is_other(name):
                self.data.ctrl[k] = other.data.ctrl[there]
                mine, theirs = self.model.actuator_actadr[k], other.model.actuator_actadr[there]
                if mine >= 0:
                    self.data.act[mine] = other.data.act[theirs]

    def settle(self) -> None:
        """Work out places, contacts and bias forces from the present positions and speeds, without a step."""
        mujoco.mj_fwdPosition(self.model, self.data)
        mujoco.mj_fwdVelocity(self.model, self.data)

    def sense(self) -> None:
        """Let the touch sensors feel the contacts of the last step; read `sensordata` before the next one."""
        self._option.disableflags = _FEELING
        mujoco.mj_sensorAcc(self.model, self.data)
        self._option.disableflags = _NUMB

    def measure(self, time: float) -> None:
        """Let all sensors measure, as of the last step; once for each time (s)."""
        if time == self._measured_at:
            return
        self._measured_at = time
        self._option.disableflags &= ~_NUMB
        mujoco.mj_sensorPos(self.model, self.data)
        mujoco.mj_sensorVel(self.model, self.data)
        mujoco.mj_sensorAcc(self.model, self.data)
        self._option.disableflags |= _NUMB

    def poses(self) -> npt.NDArray[np.float32]:
        """Place (m) and quaternion (w, x, y, z) of each body in the world, float32[bodies,7], as of the last step."""
        return np.concatenate((self.data.xpos, self.data.xquat), axis=1, dtype=np.float32)
