"""What is known of the joints of an arm, or of axes, from the compiled model of their robot and from its file."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import mujoco
import numpy as np

from onika.laws.frames import Array, inverse_pose
from onika.model.robot import Numbers, RobotArm, RobotAxes
from onika.words.reason import Reason
from onika.workcell.composed import chain
from onika.workcell.composed.servo import Gains, felt_inertia, gains

_SPEED = {False: 2.0, True: 0.5}
"""The highest speed where nobody says one: rad/s, and m/s of a joint that slides."""

_WIDE = {False: 2.0 * np.pi, True: 10.0}
"""How far a joint without limits goes either way (rad; m)."""

STRONGEST = 1000.0
"""The highest torque where nobody says one (N m; N), of all but heavy robots."""

_GRAVITY = 9.81
_HURRY = 20.0  # how much faster in a second a heavy joint can become (rad/s; m/s)

_MOST_NAMES = 20


@dataclass(frozen=True, slots=True)
class Unfit:
    """Why a device cannot be made, and the line of its block that says so."""

    keyword: str
    reason: Reason


class JointedFacts(Protocol):
    """What is known of any device that has joints."""

    @property
    def name(self) -> str:
        """The name of its block."""

    @property
    def joints(self) -> tuple[str, ...]:
        """Their names in the model."""

    @property
    def keyword(self) -> str:
        """The line of its block that says which they are."""


@dataclass(frozen=True, slots=True)
class JointFacts:
    """One device of joints, named as in its model; `constants` are what the device says of itself."""

    name: str
    drive: str
    joints: tuple[str, ...]
    actuators: tuple[str, ...]
    start: str
    """The body of frame 0; empty for axes, which have none."""
    home: Array
    lowest: Array
    highest: Array
    speed: Array
    torque: Array
    gains: Gains
    constants: Mapping[str, Numbers | str]
    held_by: tuple[Array, Array] | None = None
    """Stiffness and damping by which it holds itself, as its file says; None: by a servo within the step."""

    @property
    def keyword(self) -> str:
        """The line of its block that says which joints it has."""
        return "TOOL" if self.start else "MOVES"


def arm_facts(model: Any, arm: RobotArm, robot: str, speeds: Mapping[str, float]) -> JointFacts | Unfit:
    """An arm: the chain of joints from its base to its tool."""
    tool = _tool(model, arm)
    if isinstance(tool, Unfit):
        return tool
    body, pose_of = tool
    start = _body(model, arm.start)
    if start is None and arm.start:
        return absent(model, "FROM", "body", model.nbody, arm.start)
    try:
        joints = chain.joints_between(model, start, body)
    except ValueError as wrong:
        return Unfit("TOOL", Reason.of("workcell.joint_unfit", joint=str(wrong)))
    if not joints:
        return Unfit("TOOL", Reason.of("workcell.no_joints", tool=arm.tool))
    if start is None:
        start = int(model.body_parentid[model.jnt_bodyid[joints[0]]])
    facts = chain.chain(model, joints, start)
    data = chain.at_zero(model, joints)
    at_tool = inverse_pose(chain.body_pose(data, start)) @ pose_of(data) @ _shift(arm)
    constants = {"SCREW": facts.screw, "LINK": facts.link, "PARENT": facts.parent, "TOOL": at_tool}
    return _facts(model, arm, robot, joints, model.body(start).name, constants, speeds)


def axes_facts(model: Any, axes: RobotAxes, robot: str, speeds: Mapping[str, float]) -> JointFacts | Unfit:
    """Servos that are no chain: the joints of their actuators."""
    joints = []
    for name in axes.moves:
        actuator = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, name)
        if actuator < 0:
            return absent(model, "MOVES", "actuator", model.nu, name)
        if int(model.actuator_trntype[actuator]) != int(mujoco.mjtTrn.mjTRN_JOINT):
            return Unfit("MOVES", Reason.of("workcell.no_joint_moved", actuator=name))
        joints.append(int(model.actuator_trnid[actuator, 0]))
    return _facts(model, axes, robot, joints, "", {}, speeds)


def shared(facts: Sequence[JointedFacts], device: JointedFacts) -> Unfit | None:
    """Why a device has a joint that one before it has already."""
    for other in facts:
        both = [joint for joint in device.joints if joint in other.joints]
        if both:
            return Unfit(
                device.keyword,
                Reason.of("workcell.joint_twice", joint=both[0], other=other.name, device=device.name),
            )
    return None


def _facts(
    model: Any,
    device: RobotArm | RobotAxes,
    robot: str,
    joints: Sequence[int],
    start: str,
    constants: Mapping[str, Array],
    speeds: Mapping[str, float],
) -> JointFacts | Unfit:
    names = tuple(model.joint(joint).name for joint in joints)
    actuators = _actuators(model, joints)
    if isinstance(actuators, Unfit):
        return actuators
    said = _said(device)
    unfit = next(_miscounted(said, len(joints)), None)
    if unfit is not None:
        return unfit
    slides = [int(model.jnt_type[joint]) == int(mujoco.mjtJoint.mjJNT_SLIDE) for joint in joints]
    lowest, highest = _limits(model, joints, slides)
    home = np.array(said["HOME"]) if said["HOME"] else _home(model, joints, lowest, highest)
    if not np.all((lowest <= home) & (home <= highest)):
        wrong = int(np.flatnonzero((home < lowest) | (home > highest))[0])
        return Unfit("HOME", Reason.of("workcell.home_outside", joint=names[wrong], value=float(home[wrong])))
    usual = [speeds.get(name, _SPEED[slide]) for name, slide in zip(names, slides, strict=True)]
    speed = np.array(said["SPEED"] or usual)
    felt = _felt(model, joints, home)
    torque = np.array(said["TORQUE"] or _torques(model, actuators, joints, felt))
    published = {**constants, "QMIN": lowest, "QMAX": highest, "Q^_MAX": speed, "TAUMAX": torque, "HOME": home}
    sheet: dict[str, Numbers | str] = {name: tuple(value.ravel().tolist()) for name, value in published.items()}
    sheet |= {keyword: said[keyword] for keyword in ("KP", "KD") if keyword in said}
    sheet |= {"ROBOT": robot, "NDOF": (float(len(joints)),), "DRIVE": device.drive}
    own = tuple(model.actuator(at).name for at in actuators)
    given = _gains(model, joints, felt)
    held_by = (np.array(said["KP"]), np.array(said["KD"])) if "KP" in said else None
    return JointFacts(
        device.name, device.drive, names, own, start, home, lowest, highest, speed, torque, given, sheet, held_by
    )


def _miscounted(said: Mapping[str, Numbers], count: int) -> Iterator[Unfit]:
    """Lines that have other than a number for each joint."""
    for keyword, numbers in said.items():
        if numbers and len(numbers) != count:
            yield Unfit(keyword, Reason.of("workcell.joint_count", count=count, found=len(numbers)))


def _said(device: RobotArm | RobotAxes) -> dict[str, Numbers]:
    """The lines of a block that have a number for each joint; empty where a line is not there."""
    if isinstance(device, RobotAxes):
        return {"HOME": (), "SPEED": (), "TORQUE": ()}
    said = {"HOME": device.home, "SPEED": device.speed, "TORQUE": device.torque}
    return said | (dict(zip(("KP", "KD"), device.gains, strict=True)) if device.gains else {})


def _tool(model: Any, arm: RobotArm) -> tuple[int, Callable[[Any], Array]] | Unfit:
    """The body that bears the tool, and where its site or body is."""
    site = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, arm.tool)
    if site >= 0:
        return int(model.site_bodyid[site]), lambda data: chain.site_pose(data, site)
    body = _body(model, arm.tool)
    if body is None:
        return absent(model, "TOOL", "site", model.nsite, arm.tool)
    return body, lambda data: chain.body_pose(data, body)


def _body(model: Any, name: str) -> int | None:
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name) if name else -1
    return body if body >= 0 else None


def _shift(arm: RobotArm) -> Array:
    """The tool in the frame of its site: z the approach, y along the fingers."""
    approach, fingers = _axis(arm.approach), _axis(arm.fingers)
    pose = np.eye(4)
    pose[:3, :3] = np.stack((np.cross(fingers, approach), fingers, approach), axis=1)
    pose[:3, 3] = arm.offset
    return pose


def _axis(word: str) -> Array:
    axis: Array = np.eye(3)["xyz".index(word[-1])]
    return -axis if word[0] == "-" else axis


def _actuators(model: Any, joints: Sequence[int]) -> tuple[int, ...] | Unfit:
    """The actuator of each joint."""
    of_joint: dict[int, int] = {}
    for actuator in range(model.nu):
        if int(model.actuator_trntype[actuator]) == int(mujoco.mjtTrn.mjTRN_JOINT):
            of_joint.setdefault(int(model.actuator_trnid[actuator, 0]), actuator)
    lacking = [model.joint(joint).name for joint in joints if joint not in of_joint]
    if lacking:
        return Unfit("TOOL", Reason.of("workcell.no_actuator", joint=lacking[0]))
    return tuple(of_joint[joint] for joint in joints)


def _limits(model: Any, joints: Sequence[int], slides: Sequence[bool]) -> tuple[Array, Array]:
    lowest, highest = np.zeros(len(joints)), np.zeros(len(joints))
    for k, joint in enumerate(joints):
        wide = _WIDE[slides[k]]
        has_limits = bool(model.jnt_limited[joint])
        lowest[k], highest[k] = model.jnt_range[joint] if has_limits else (-wide, wide)
    return lowest, highest


def _home(model: Any, joints: Sequence[int], lowest: Array, highest: Array) -> Array:
    """The keyframe `home`, else zero, within the limits."""
    at = [int(model.jnt_qposadr[joint]) for joint in joints]
    keys = [k for k in range(model.nkey) if model.key(k).name == "home"]
    home = np.array(model.key_qpos[keys[0]][at]) if keys else np.zeros(len(joints))
    inside: Array = np.clip(home, lowest, highest)
    return inside


def highest_torque(model: Any, actuator: int, joint: int) -> float:
    """The highest torque of a joint as its model says it."""
    gear = abs(float(model.actuator_gear[actuator, 0]))
    if model.actuator_forcelimited[actuator]:
        return gear * float(np.abs(model.actuator_forcerange[actuator]).max())
    if model.jnt_actfrclimited[joint]:
        return float(np.abs(model.jnt_actfrcrange[joint]).max())
    is_motor = int(model.actuator_biastype[actuator]) == int(mujoco.mjtBias.mjBIAS_NONE)
    if is_motor and model.actuator_ctrllimited[actuator]:
        strength = abs(float(model.actuator_gainprm[actuator, 0]))
        return gear * strength * float(np.abs(model.actuator_ctrlrange[actuator]).max())
    return STRONGEST


def _torques(model: Any, actuators: Sequence[int], joints: Sequence[int], felt: Array) -> list[float]:
    """The highest torques; where nobody says one, as much as lifts and hurries what hangs on the joint."""
    torques = []
    for actuator, joint, inertia in zip(actuators, joints, felt.tolist(), strict=True):
        torque = highest_torque(model, actuator, joint)
        if torque == STRONGEST:
            mass = float(np.ravel(model.body_subtreemass[model.jnt_bodyid[joint]])[0])
            weight = _GRAVITY * float(np.sqrt(mass * inertia))  # no lever is longer than that of all mass in one point
            torque = max(torque, float(np.ceil(weight + _HURRY * inertia)))
        torques.append(torque)
    return torques


def _felt(model: Any, joints: Sequence[int], home: Array) -> Array:
    """The inertia that each joint feels at home (kg m2; kg where it slides)."""
    data = mujoco.MjData(model)
    for joint, value in zip(joints, home, strict=True):
        data.qpos[model.jnt_qposadr[joint]] = value
    return felt_inertia(model, data, _dofs(model, joints))


def _dofs(model: Any, joints: Sequence[int]) -> Array:
    return np.array([int(model.jnt_dofadr[joint]) for joint in joints])


def _gains(model: Any, joints: Sequence[int], felt: Array) -> Gains:
    dofs = _dofs(model, joints)
    damping, friction = (
        np.array([float(np.ravel(of[dof])[0]) for dof in dofs]) for of in (model.dof_damping, model.dof_frictionloss)
    )
    springs = np.array([float(np.ravel(model.jnt_stiffness[joint])[0]) for joint in joints])
    slack = np.array([float(model.qpos_spring[model.jnt_qposadr[joint]]) for joint in joints])
    return gains(felt, damping, friction, springs, slack)


def absent(model: Any, keyword: str, kind: str, count: int, name: str) -> Unfit:
    """That a model has no `name` of this kind, of which it has `count`."""
    names = [getattr(model, kind)(k).name for k in range(count)]
    there = tuple(name for name in names if name)[:_MOST_NAMES] or Reason.of("workcell.none")
    return Unfit(keyword, Reason.of("workcell.no_such_name", there=there, name=name))
