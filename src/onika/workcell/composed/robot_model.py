"""A robot compiled by itself: the constants of its devices, the same wherever it will stand."""

import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree

import mujoco
import numpy as np

from onika.model.robot import RobotArm, RobotAxes, RobotBase, RobotDevice, RobotGripper, RobotText, SensorBlock
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason, reason_of
from onika.workcell.composed.base_facts import FREE_JOINT, BaseFacts, base_facts
from onika.workcell.composed.camera_spec import add_cameras, lenses
from onika.workcell.composed.gripper_facts import GripperFacts, gripper_facts
from onika.workcell.composed.joint_facts import JointFacts, Unfit, arm_facts, axes_facts, shared
from onika.workcell.composed.model_fault import OF_MODELS, ModelFault
from onika.workcell.composed.sensor_unit import lacking
from onika.workcell.composed.sources import SourceTexts, first_line

HAND = "hand."
"""Before the names of what belongs to a hand that is attached."""

ORIGIN = "robot.origin"
"""A site of every robot: the middle of its document, which is frame 0 where nothing bears the first joint."""

_FASTEST = {False: 600.0, True: 30.0}  # how much faster in a second its motor makes a finger at most: rad/s, m/s
_DEEP_M = 0.001  # how far shapes reach into each other that a document forgot to keep apart
_URDF = ".urdf"
_KEYWORDS = {"workcell.no_such_name": "ON"}
"""The lines of a robot's file of which reasons speak that are not about a model by itself."""


DeviceFacts = JointFacts | GripperFacts | BaseFacts | SensorBlock


@dataclass(frozen=True, slots=True)
class RobotModel:
    """A robot's file, and what is known of its devices; what cannot be used is lacking, with a fault.

    excluded   pairs of bodies that reach into each other at home, as their shapes are drawn and not meant to meet
    lenses     how much each of its cameras sees from below to above (degrees)
    """

    robot: RobotText
    joints: tuple[JointFacts, ...]
    grippers: tuple[GripperFacts, ...]
    excluded: tuple[tuple[str, str], ...]
    lenses: Mapping[str, float]
    bases: tuple[BaseFacts, ...] = ()
    sensors: tuple[SensorBlock, ...] = ()

    @property
    def usable(self) -> frozenset[str]:
        """The names of its devices that move."""
        joints, bases = {facts.name for facts in self.joints}, {facts.name for facts in self.bases}
        return frozenset(joints | bases | {facts.gripper.name for facts in self.grippers})


def robot_spec(sources: SourceTexts, robot: RobotText) -> mujoco.MjSpec:
    """The document of a robot with links and hand, ready to be attached; raises ValueError with the reason why not."""
    spec = sources.model(f"robot/{robot.file}")
    end = robot.on
    for number, link in enumerate(robot.links, 1):
        _attach(spec, sources.model(f"robot/{link}"), end, f"{number}.")
        end = f"{number}.{robot.on}"
    has_motors = bool(len(spec.actuators))
    if robot.hand:
        _attach(spec, sources.model(f"robot/{robot.hand}"), end, HAND)
    _free(spec, robot)
    _name(spec)
    _let_go(spec)
    spec.worldbody.add_site(name=ORIGIN)
    add_cameras(spec, robot.cameras)
    _refuse_reversed(spec)
    for body in spec.bodies[1:]:
        body.gravcomp = 1.0  # there when it is compiled, so that a drive may bear the weight; a motor takes it back
    if not has_motors:
        _add_motors(spec, is_hand_driven=bool(len(spec.actuators)))
        _gear_fingers(spec, robot)
    armature = [device.armature for device in robot.devices if isinstance(device, RobotArm) and device.armature]
    for joint in _moving(spec):
        joint.armature += armature[0] if armature else 0.0
    return spec


def robot_model(sources: SourceTexts, robot: RobotText, faults: list[Fault]) -> RobotModel | None:
    """Compile a robot by itself; None, with a fault, where nothing of it can be used."""
    try:
        model = compiled(robot_spec(sources, robot))
    except ValueError as wrong:
        faults.append(_unusable(sources, robot, wrong))
        return None
    speeds = _speeds(sources, robot)
    usable: list[DeviceFacts] = []
    for device in robot.devices:
        facts = _facts(model, device, robot.kind, speeds)
        if isinstance(facts, JointFacts | BaseFacts):
            facts = shared([other for other in usable if isinstance(other, JointFacts | BaseFacts)], facts) or facts
        if isinstance(facts, Unfit):
            place = sources.robot_place(robot.name, device.lines.get(facts.keyword, min(device.lines.values())))
            instead = Reason.of("workcell.device_left_out", name=device.name)
            faults.append(Fault(place, facts.reason, instead))
        else:
            usable.append(facts)
    joints = tuple(facts for facts in usable if isinstance(facts, JointFacts))
    return RobotModel(
        robot,
        joints,
        tuple(facts for facts in usable if isinstance(facts, GripperFacts)),
        tuple(_touching(model, robot, joints)),
        lenses(model),
        tuple(facts for facts in usable if isinstance(facts, BaseFacts)),
        tuple(facts for facts in usable if isinstance(facts, SensorBlock)),
    )


def _unusable(sources: SourceTexts, robot: RobotText, wrong: ValueError) -> Fault:
    """Why nothing of a robot can be used: at the line of its model that is to blame, else at that of its own file."""
    reason, instead = reason_of(wrong), Reason.of("workcell.robot_left_out", name=robot.name)
    models = {"": robot.file} | {f"{number}.": link for number, link in enumerate(robot.links, 1)}
    models |= {HAND: robot.hand} if robot.hand else {}
    if reason.key in OF_MODELS:
        wrong = sources.model_fault(reason, {prefix: f"robot/{file}" for prefix, file in models.items()})
    if isinstance(wrong, ModelFault) and wrong.place.line:
        return Fault(wrong.place, reason, instead, because=(wrong.place,))  # two robots may have the same model
    place = sources.robot_place(robot.name, robot.lines.get(_KEYWORDS.get(reason.key, "FILE"), 0))
    return Fault(place, reason, instead, because=(place,))  # it may have been told already that a file is not there


def at_home(model: Any, devices: Iterable[JointFacts], prefix: str = "") -> Any:
    """The model's data with these devices at home; `prefix` stands before the names of their joints."""
    data = mujoco.MjData(model)
    for facts in devices:
        for name, value in zip(facts.joints, facts.home, strict=True):
            data.joint(prefix + name).qpos[0] = value
    mujoco.mj_forward(model, data)
    return data


def held_by_mocap(spec: mujoco.MjSpec) -> Iterator[str]:
    """The bodies that a hand of the simulator leads, which no program of ours moves."""
    for first, other in ((bond.name1, bond.name2) for bond in _leads(spec)):
        yield other if _is_led(spec, first) else first


def compiled(spec: mujoco.MjSpec) -> Any:
    """The model of a document; raises ValueError with what MuJoCo says of it."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # that a model says options; the world says them
            model = spec.compile()
    except (ValueError, RuntimeError) as wrong:
        raise ValueError(Reason.of("workcell.model_unsound", why=first_line(wrong))) from None
    if nowhere := _nowhere(model):
        raise ValueError(nowhere)
    return model


def _nowhere(model: Any) -> Reason:
    """Which element stands at no place that can be computed with, which MuJoCo lets pass; empty where each does."""
    stand = {
        "body": model.body_pos,
        "geom": model.geom_pos,
        "site": model.site_pos,
        "joint": model.jnt_pos,
        "camera": model.cam_pos,
    }
    for kind, places in stand.items():
        is_there = (np.abs(places) < mujoco.mjMAXVAL).all(axis=1)  # what is no number is below nothing
        if not is_there.all():
            number = int(np.argmin(is_there))
            name, found = getattr(model, kind)(number).name, " ".join(f"{x:g}" for x in places[number])
            return Reason.of("workcell.place_no_number", kind=kind, name=name, found=found)
    return NOTHING


def _facts(model: Any, device: RobotDevice, robot: str, speeds: dict[str, float]) -> DeviceFacts | Unfit:
    match device:
        case RobotArm():
            return arm_facts(model, device, robot, speeds)
        case RobotAxes():
            return axes_facts(model, device, robot, speeds)
        case RobotGripper():
            return gripper_facts(model, device, robot)
        case RobotBase():
            return base_facts(model, device, robot)
        case SensorBlock():
            return lacking(model, device) or device


def _attach(spec: mujoco.MjSpec, child: mujoco.MjSpec, end: str, prefix: str) -> None:
    """Attach another document at a site; raises ValueError where there is none of this name."""
    site = next((site for site in spec.sites if site.name == end), None)
    if site is None:
        there = tuple(site.name for site in spec.sites)[:20] or Reason.of("workcell.none")
        raise ValueError(Reason.of("workcell.no_such_name", there=there, name=end))
    spec.attach(child, site=site, prefix=prefix)


def _free(spec: mujoco.MjSpec, robot: RobotText) -> None:
    """What drives on wheels stands on them."""
    body = spec.worldbody.first_body()
    drives = any(isinstance(device, RobotBase) and device.wheels for device in robot.devices)
    if drives and body is not None and not len(body.joints):
        body.add_freejoint(name=FREE_JOINT)


def _let_go(spec: mujoco.MjSpec) -> None:
    """Nothing of a robot is held where a hand of the simulator once stood."""
    for bond in [*_leads(spec)]:
        spec.delete(bond)


def _leads(spec: mujoco.MjSpec) -> Iterator[Any]:
    kinds = (mujoco.mjtEq.mjEQ_WELD, mujoco.mjtEq.mjEQ_CONNECT)
    for bond in spec.equalities:
        if bond.type in kinds and (_is_led(spec, bond.name1) or _is_led(spec, bond.name2)):
            yield bond


def _is_led(spec: mujoco.MjSpec, body: str) -> bool:
    return any(each.mocap and each.name == body for each in spec.bodies)


def _name(spec: mujoco.MjSpec) -> None:
    """Whatever moves or is moved has a name of its own."""
    for number, joint in enumerate(spec.joints):
        joint.name = joint.name or f"joint.{number}"
    for number, body in enumerate(spec.bodies[1:], start=1):
        body.name = body.name or f"body.{number}"
    for number, actuator in enumerate(spec.actuators):
        actuator.name = actuator.name or f"actuator.{number}"


def _add_motors(spec: mujoco.MjSpec, *, is_hand_driven: bool) -> None:
    """A motor at each joint that nothing else drives, but for those of a hand that has motors of its own."""
    driven = {equality.name1 for equality in spec.equalities if equality.type == mujoco.mjtEq.mjEQ_JOINT}
    for joint in _moving(spec):
        if joint.name not in driven and not (is_hand_driven and joint.name.startswith(HAND)):
            actuator = spec.add_actuator(name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
            actuator.set_to_motor()  # a model may have defaults of servos, which would pull it to 0
            actuator.ctrllimited = False


def _gear_fingers(spec: mujoco.MjSpec, robot: RobotText) -> None:
    """Fingers that our motors move feel a gear behind them where the model says none, as no URDF can; so do followers.

    Without it a motor of 10 N m at a finger of some grams pushes it through its stop, which is soft, and on; and one
    that follows gives way to what it presses on.
    """
    led = {name for device in robot.devices if isinstance(device, RobotGripper) for name in device.moves}
    joints = {joint.name: joint for joint in _moving(spec)}
    coupled = [each for each in spec.equalities if each.type == mujoco.mjtEq.mjEQ_JOINT]
    leaders = {each.name1: each.name2 for each in coupled} | {name: name for name in led}
    for name, leader in leaders.items():
        joint, motor = joints.get(name), joints.get(leader)
        if joint is not None and motor is not None and leader in led and not np.any(joint.armature):
            fastest = _FASTEST[joint.type == mujoco.mjtJoint.mjJNT_SLIDE]
            joint.armature = float(np.max(np.abs(motor.actfrcrange))) / fastest


def _moving(spec: mujoco.MjSpec) -> Iterator[Any]:
    kinds = (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE)
    return (joint for joint in spec.joints if joint.type in kinds)


def _speeds(sources: SourceTexts, robot: RobotText) -> dict[str, float]:
    """The highest speed of each joint as a URDF says it; MuJoCo drops them."""
    file = sources.files.find(f"robot/{robot.file}")
    if file is None or not robot.file.endswith(_URDF):
        return {}
    root = ElementTree.fromstring(file.content)  # noqa: S314 - MuJoCo has read it before
    limits = {joint.get("name", ""): joint.find("limit") for joint in root.iter("joint")}
    given = {name: limit.get("velocity") for name, limit in limits.items() if limit is not None}
    return {name: float(speed) for name, speed in given.items() if speed and float(speed) > 0.0}


def _touching(model: Any, robot: RobotText, joints: tuple[JointFacts, ...]) -> Iterator[tuple[str, str]]:
    """Bodies that reach into each other at home: of a URDF any two, else a link and what bears it."""
    data = at_home(model, joints)
    pairs = set()
    for contact in np.flatnonzero(data.contact.dist < -_DEEP_M).tolist():
        first, other = sorted(int(model.geom_bodyid[geom]) for geom in data.contact.geom[contact])
        if first and (robot.file.endswith(_URDF) or int(model.body_parentid[other]) == first):
            pairs.add((model.body(first).name, model.body(other).name))
    yield from sorted(pairs)


def _refuse_reversed(spec: mujoco.MjSpec) -> None:
    for joint in _moving(spec):
        low, high = (float(end) for end in joint.range)
        if low > high:
            raise ValueError(Reason.of("workcell.limit_reversed", joint=joint.name, low=low, high=high))
