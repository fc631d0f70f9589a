"""A guarded motion in the world of the boxes: the servo's torque tells of a box, and the hand presses no harder."""

import mujoco
import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from onika.laws import puma560
from onika.laws.robot import published
from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder
from onika.store.shipped import shipped
from onika.testing.bench import Bench

GENERIC = shipped() / "generic" / "module"
CONSTANTS = published(puma560, 0.0, 0.0, 0.0, 0.0)
ABOVE = np.array([0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238])
STEP_NS = 2_000_000
ARM, HAND = "arm_left", "gripper_left"
MARGIN = 10.0
"""N: what an arm of 20 kg at 2 cm/s brings along at the first touch."""


class Cell:
    """The left arm above the box with the triangle, its servo, and a guarded motion, each at its own rate."""

    def __init__(self):
        self.world = boxes_world()
        for device in (ARM, HAND):
            self.world.claim(device, 1)
        self._begin_above()
        self.fwdkin = self._task("fwdkin", 250, "NDOF SCREW PARENT BASE TOOL")
        self.invkin = self._task("invkin", 250, "NDOF SCREW PARENT BASE TOOL QMIN QMAX Q^_MAX")
        self.gravcomp = self._task("gravcomp", 250, "NDOF SCREW LINK PARENT LOAD BASE")
        self.tool_force = self._task("tool_force", 250, "NDOF SCREW PARENT BASE TOOL")
        self.cguard = self._task("cguard", 250, "")
        self.diff, self.pd = self._task("diff", 500, "NDOF"), self._task("pd", 500, "NDOF KP KD")
        self.pressed, self.felt, self.heights = [], [], []

    def _begin_above(self):
        arm = next(unit for unit in self.world._acting if unit.sheet.name == ARM)
        where, _ = self.world._plant.joints([*arm.joint_names])
        self.world._plant.data.qpos[where] = ABOVE
        arm.capture()
        self.world.step(self.world.now_ns + 250 * STEP_NS)

    def _task(self, name, frequency, constants):
        return Bench(
            GENERIC / f"{name}.py", frequency=frequency, constants={each: CONSTANTS[each] for each in constants.split()}
        ).init()

    @property
    def angles(self):
        return np.array(self.world.state(ARM)[2:])

    def lower(self, height, limit):
        """Down to a height, and half a second longer."""
        angles = self.angles
        self.diff["Y"] = self.fwdkin["Q_MEZ"] = self.gravcomp["Q_MEZ"] = self.pd["Q_MEZ"] = angles
        self.pd["Q_REF"] = self.invkin["Q_MEZ"] = self.tool_force["Q_MEZ"] = angles
        for task in (self.diff, self.fwdkin, self.gravcomp, self.pd, self.tool_force):
            task.on()
        self.cguard["X_MEZ"] = self.invkin["X_REF"] = self.fwdkin["X_MEZ"]
        self.cguard.on(f"0 0 -1 0 1 0 0.7 0.28 {height} 1 {limit} 10")
        self.invkin.on()
        after = 0
        while after < 250:
            self._step()
            after += self.cguard.state is not State.ON
        return self

    def _step(self):
        angles = self.diff["Y"] = self.angles
        self.diff.cycle()
        if len(self.heights) % 2 == 0:
            self._plan(angles)
        pd = self.pd
        pd["Q_MEZ"], pd["Q^_MEZ"] = angles, self.diff["Y^"]
        pd["Q_REF"], pd["Q^_REF"] = self.invkin["Q_REF"], self.invkin["Q^_REF"]
        torque = pd.cycle()["TAU_PD"] + self.gravcomp["TAU_G"]
        self.world.command(ARM, 1, int(DeviceOrder.DRIVE), torque)
        self.world.step(self.world.now_ns + STEP_NS)
        self.pressed.append(self._contact())
        self.felt.append(float(np.linalg.norm(self.tool_force["F_MEZ"][:3])))
        self.heights.append(float(self.fwdkin["X_MEZ"][2, 3]))

    def _plan(self, angles):
        self.fwdkin["Q_MEZ"] = self.gravcomp["Q_MEZ"] = self.tool_force["Q_MEZ"] = self.invkin["Q_MEZ"] = angles
        self.gravcomp["Q^_MEZ"], self.tool_force["TAU_PD"] = self.diff["Y^"], self.pd["TAU_PD"]
        self.gravcomp.cycle()
        self.cguard["X_MEZ"], self.cguard["F_MEZ"] = self.fwdkin.cycle()["X_MEZ"], self.tool_force.cycle()["F_MEZ"]
        if self.cguard.state is State.ON:
            self.cguard.cycle()
        self.invkin["X_REF"] = self.cguard["X_REF"]
        self.invkin.cycle()

    def _contact(self):
        """How hard arm and hand really press on what is neither, in N."""
        plant, whole, force = self.world._plant, 0.0, np.zeros(6)
        for number in range(plant.data.ncon):
            contact = plant.data.contact[number]
            names = [plant.model.body(plant.model.geom_bodyid[geom]).name for geom in (contact.geom1, contact.geom2)]
            if len({name.startswith("left.") for name in names}) == 2:
                mujoco.mj_contactForce(plant.model, plant.data, number, force)
                whole += float(force[0])
        return whole


@pytest.mark.parametrize("limit", [20.0, 40.0])
def test_a_box_is_met_the_motion_ends_and_the_hand_presses_no_harder_and_keeps_still(limit):  # R-D25
    cell = Cell().lower(-0.31, limit)
    assert cell.cguard.finished.flow == 1
    assert max(cell.felt) <= limit + 2.0
    assert limit - 2.0 <= max(cell.pressed) <= limit + MARGIN
    assert 1.0 < cell.pressed[-1] <= 0.6 * limit  # it rests on it
    assert np.ptp(cell.heights[-200:]) < 1e-4


def test_in_the_air_nothing_is_felt_that_could_be_met():  # R-D25
    cell = Cell().lower(-0.2, 10.0)
    assert cell.cguard.finished.flow == 0
    assert max(cell.felt) < 3.0 and max(cell.pressed) == 0.0
    assert cell.heights[-1] == pytest.approx(-0.2, abs=1e-3)
