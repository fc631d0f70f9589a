"""The first draft of a robot's description: `python -m onika.workcell.drafting.draft NAME FILE < files > draft`.

The input is a `WorldSource` with the model and what it needs, the output a `RobotDraft`, both in msgpack. It is a
program of its own, so that whoever writes descriptions needs no physics. Exit 0: there is an answer; 2: wrong words.
"""

import sys
from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np
from msgspec import msgpack
from msgspec.structs import replace

from onika.files import robot as robot_file
from onika.laws.frames import Array
from onika.model.robot import RobotArm, RobotAxes, RobotDevice, RobotGripper, RobotText
from onika.wire.robot_draft import RobotDraft
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault
from onika.words.reason import Reason, reason_of
from onika.workcell.composed.gripper_facts import GripperFacts
from onika.workcell.composed.joint_facts import STRONGEST, JointFacts
from onika.workcell.composed.robot_model import RobotModel, compiled, held_by_mocap, robot_model, robot_spec
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.drafting.draft_base import AHEAD_M, BASE, DraftBase, draft_base
from onika.workcell.drafting.draft_cameras import draft_cameras
from onika.workcell.drafting.draft_chain import MOVING, DraftChain, DraftTool, draft_chain, draft_tool, driven_joints
from onika.workcell.drafting.draft_gripper import DraftHand, draft_hand
from onika.workcell.drafting.draft_home import DraftHome, draft_home
from onika.workcell.drafting.draft_jaw import between_jaws
from onika.workcell.drafting.draft_motion import (
    ANY_POSE,
    beside_home,
    lowest_point,
    seconds_between,
    straight_line,
)
from onika.workcell.drafting.draft_motors import undriven
from onika.workcell.drafting.draft_pictures import draft_pictures
from onika.workcell.drafting.draft_units import doubtful_units

Comment = tuple[str, str, Reason]
Guesses = tuple[DraftChain, DraftTool, DraftHand, DraftHome]

_SPARE_M = 0.02  # so much below the lowest shape is the floor where it has to be lower than 0
_TOUCH_M = 0.001
_GENTLE_N = 20.0  # what jobs let a gripper press with, where it can: more pushes light things away
_URDF = ".urdf"


def main(words: list[str]) -> int:
    """Read the files, write the draft; gives the exit code."""
    if len(words) != 2:
        sys.stderr.write("usage: python -m onika.workcell.drafting.draft NAME FILE < files > draft\n")
        return 2
    mujoco.set_mju_user_warning(lambda _text: None)
    files = msgpack.decode(sys.stdin.buffer.read(), type=WorldSource)
    sys.stdout.buffer.write(msgpack.encode(draft(files, *words)))
    return 0


def draft(files: WorldSource, name: str, file: str) -> RobotDraft:
    """The draft of the robot `name` with the model `file`; with a refusal where there can be none."""
    sources = SourceTexts(files)
    bare = RobotText(name, file)
    try:
        model = compiled(robot_spec(sources, bare))
    except ValueError as wrong:
        return RobotDraft(refusal=reason_of(wrong), unusable=tuple(_unusable(files)))
    base = draft_base(model)
    chain = draft_chain(model, base.joints if base else ())
    lacking = () if base else undriven(model, chain)
    if chain is None or lacking:
        return _without_arm(model, base, bare, sources, lacking)
    home = draft_home(model, chain, is_apart=file.endswith(_URDF))
    hand = draft_hand(model, chain, home.values)
    at_home = _data(model, chain, home.values)
    tool = draft_tool(model, at_home, chain, hand.fingers)
    if hand.jaw is not None:
        tool = between_jaws(model, at_home, tool, hand.jaw)
    devices = (*([base.device] if base else []), *_devices(model, chain, tool, hand, home, base))
    cameras = draft_cameras(model, [device.name for device in devices])
    robot = RobotText(name, file, name, devices=devices, cameras=cameras)
    faults: list[Fault] = []
    known = robot_model(sources, robot, faults)
    arm = next((facts for facts in known.joints if facts.start), None) if known else None
    if known is None or arm is None:
        return RobotDraft(refusal=faults[0].reason)
    complete = _complete(model, known, arm, (chain, tool, hand, home), faults, sources)
    return complete if base is None else _on_base(complete, base)


def _nothing_driven(model: Any) -> Reason:
    """Why there is no arm: nothing turns or slides, or nothing drives what does."""
    moving = (joint for joint in range(model.njnt) if int(model.jnt_type[joint]) in MOVING)
    loose = tuple(model.joint(joint).name for joint in moving if joint not in driven_joints(model))
    if not loose:
        return Reason.of("workcell.draft_no_joints")
    return Reason.of("workcell.draft_none_driven", joints=loose, count=model.nu)


def _without_arm(
    model: Any, base: DraftBase | None, bare: RobotText, sources: SourceTexts, lacking: tuple[str, ...]
) -> RobotDraft:
    """The draft of a robot that only drives; a refusal of one that does not, with the joints that would need motors."""
    if base is None:
        return RobotDraft(refusal=_nothing_driven(model), undriven=lacking)
    cameras = draft_cameras(model, [BASE])
    robot = RobotText(bare.name, bare.file, bare.name, devices=(base.device,), cameras=cameras)
    faults: list[Fault] = []
    known = robot_model(sources, robot, faults)
    if known is None or not known.bases:
        return RobotDraft(refusal=faults[0].reason)
    comments = [("CAMERA", "CAMERA", Reason.of("workcell.draft_camera"))] if cameras else []
    notes = [] if len(sources.model(f"robot/{bare.file}").actuators) else [Reason.of("workcell.draft_motors")]
    text = robot_file.write(robot)
    return _on_base(RobotDraft(text=text, comments=tuple(comments), notes=tuple(notes)), base)


def _on_base(draft: RobotDraft, base: DraftBase) -> RobotDraft:
    """A draft with the base that its robot drives on."""
    keyword = "WHEELS" if base.device.wheels else "SLIDES"
    comments = (*draft.comments, ("BASE", keyword, base.origin), ("BASE", "SPEED", Reason.of("workcell.draft_speed")))
    floor = base.floor if base.device.wheels else draft.floor
    notes = (*draft.notes, *([Reason.of("workcell.draft_floor", floor=floor)] if floor and not draft.floor else []))
    return replace(draft, comments=comments, notes=notes, floor=floor, ahead=(AHEAD_M, 0.0, 0.0))


def _complete(
    model: Any,
    known: RobotModel,
    arm: JointFacts,
    guesses: Guesses,
    faults: list[Fault],
    sources: SourceTexts,
) -> RobotDraft:
    """The draft with what is known of the devices that can be used."""
    chain, _, hand, _ = guesses
    devices = tuple(_filled(device, arm) for device in known.robot.devices if device.name in known.usable)
    robot = RobotText(
        known.robot.name, known.robot.file, known.robot.description, devices=devices, cameras=known.robot.cameras
    )
    away = beside_home(model, arm, known.excluded)
    line, line_s, along = straight_line(model, arm, known.joints, away, known.excluded)
    lowest = lowest_point(model, arm, (arm.home, away, *along))
    floor = 0.0 if lowest > -_TOUCH_M else float(np.floor(100.0 * (lowest - _SPARE_M)) / 100.0)
    urdf_speeds = known.robot.file.endswith(_URDF)
    gripper = known.grippers[0] if known.grippers else None
    notes = [*chain.notes, *(Reason.of("workcell.draft_fault", reason=fault.reason) for fault in faults)]
    notes += doubtful_units(model, arm)
    notes += _missing(model, chain, arm, sources, known.robot.file)
    notes += [Reason.of("workcell.draft_still")] if np.array_equal(away, arm.home) else []
    if not line or len(arm.joints) < ANY_POSE:
        key = "workcell.draft_line_few" if line else "workcell.draft_no_line"
        notes += [Reason.of(key, count=len(arm.joints))]
    notes += [Reason.of("workcell.draft_floor", floor=floor)] if floor else []
    notes += [Reason.of("workcell.draft_no_gripper")] if gripper is None else []
    notes += [hand.origin] if isinstance(hand.device, RobotAxes) else []
    return RobotDraft(
        text=robot_file.write(robot),
        comments=tuple(_comments(model, robot, arm, guesses, is_urdf=urdf_speeds)),
        notes=tuple(notes),
        floor=floor,
        home=tuple(arm.home.tolist()),
        away=tuple(away.tolist()),
        seconds=seconds_between(arm, away),
        line=line,
        line_s=line_s,
        opening=_opening(gripper) if gripper else (),
        pictures=draft_pictures(model, chain.joints, (arm.home, away)),
    )


def _opening(gripper: GripperFacts) -> tuple[float, ...]:
    force = float(np.clip(0.5 * gripper.force, 0.1, _GENTLE_N))
    return gripper.gripper.open[1], gripper.gripper.closed[1], round(force, 2)


def _devices(
    model: Any, chain: DraftChain, tool: DraftTool, hand: DraftHand, home: DraftHome, base: DraftBase | None
) -> Iterator[RobotDevice]:
    values = () if home.is_usual else tuple(map(float, home.values))
    lines = {"ARM": 1}
    yield RobotArm("arm", tool.name, tool.offset, tool.approach, tool.fingers, chain.start, home=values, lines=lines)
    if hand.device is not None:
        yield _lined(hand.device)
    taken = set(hand.device.moves) if isinstance(hand.device, RobotAxes | RobotGripper) else set()
    joint = int(mujoco.mjtTrn.mjTRN_JOINT)
    others = [
        model.actuator(k).name
        for k in range(model.nu)
        if int(model.actuator_trntype[k]) == joint
        and int(model.actuator_trnid[k, 0]) not in (*chain.joints, *(base.joints if base else ()))
        and int(model.jnt_bodyid[int(model.actuator_trnid[k, 0])]) not in hand.fingers
        and model.actuator(k).name not in taken
    ]
    if others:
        yield RobotAxes("others", tuple(others[:64]), lines={"AXES": 1})


def _lined(device: RobotDevice) -> RobotDevice:
    """A device with a line, as that of a file has one."""
    if isinstance(device, RobotGripper):
        return RobotGripper(device.name, device.moves, device.open, device.closed, device.force, {"GRIPPER": 1})
    return RobotAxes(device.name, device.moves, lines={"AXES": 1}) if isinstance(device, RobotAxes) else device


def _filled(device: RobotDevice, arm: JointFacts) -> RobotDevice:
    """An arm with all that was found out of it."""
    if not isinstance(device, RobotArm):
        return device
    home, speed, torque = (tuple(map(float, values)) for values in (arm.home, arm.speed, arm.torque))
    return RobotArm(
        device.name, device.tool, device.offset, device.approach, device.fingers, device.start,
        home=home, speed=speed, torque=torque,
    )  # fmt: skip


def _comments(
    model: Any,
    robot: RobotText,
    arm: JointFacts,
    guesses: Guesses,
    *,
    is_urdf: bool,
) -> Iterator[Comment]:
    _, tool, hand, home = guesses
    yield "ARM", "ARM", Reason.of("workcell.draft_arm", count=len(arm.joints), joints=arm.joints)
    yield "ARM", "TOOL", tool.origin
    yield "ARM", "APPROACH", Reason.of("workcell.draft_axes")
    yield "ARM", "FROM", Reason.of("workcell.draft_from")
    yield "ARM", "HOME", home.origin
    yield "ARM", "SPEED", Reason.of("workcell.draft_speed_urdf" if is_urdf else "workcell.draft_speed")
    is_known = bool(np.all(arm.torque < STRONGEST))
    yield "ARM", "TORQUE", Reason.of("workcell.draft_torque" if is_known else "workcell.draft_torque_none")
    if isinstance(hand.device, RobotGripper):
        yield "GRIPPER", "OPEN", hand.origin
    if any(device.name == "others" for device in robot.devices):
        yield "AXES", "AXES", Reason.of("workcell.draft_others")
    if robot.cameras:
        yield "CAMERA", "CAMERA", Reason.of("workcell.draft_camera")


def _missing(model: Any, chain: DraftChain, arm: JointFacts, sources: SourceTexts, file: str) -> Iterator[Reason]:
    """What an arm needs and its model does not say."""
    endless = tuple(model.joint(k).name for k in chain.joints if not model.jnt_limited[k])
    if endless:
        yield Reason.of("workcell.draft_endless", joints=endless)
    weak = tuple(name for name, torque in zip(arm.joints, arm.torque, strict=True) if torque >= STRONGEST)
    if weak:
        yield Reason.of("workcell.draft_strong", joints=weak, most=float(arm.torque.max()))
    light = tuple(
        model.body(body).name for body in dict.fromkeys(int(model.jnt_bodyid[k]) for k in chain.joints)
        if float(np.ravel(model.body_subtreemass[body])[0]) < 1e-4
    )  # fmt: skip
    if light:
        yield Reason.of("workcell.draft_massless", bodies=light)
    held = tuple(held_by_mocap(sources.model(f"robot/{file}")))
    if held:
        yield Reason.of("workcell.draft_held", bodies=held)
    if not len(sources.model(f"robot/{file}").actuators):
        yield Reason.of("workcell.draft_motors")
    coupled = int(np.sum(model.eq_type == int(mujoco.mjtEq.mjEQ_JOINT))) if model.neq else 0
    if coupled:
        yield Reason.of("workcell.draft_coupled", count=coupled)


def _data(model: Any, chain: DraftChain, home: Array) -> Any:
    data = mujoco.MjData(model)
    data.qpos[[int(model.jnt_qposadr[joint]) for joint in chain.joints]] = home
    mujoco.mj_forward(model, data)
    return data


def _unusable(files: WorldSource) -> Iterator[str]:
    """The meshes of a model that MuJoCo does not take, each tried alone."""
    for file in files.files:
        if file.name.rpartition(".")[2] not in ("stl", "obj", "msh", "dae"):
            continue
        spec = mujoco.MjSpec()
        spec.add_mesh(name="mesh", file=file.name)
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="mesh")
        spec.assets = {file.name: file.content}
        try:
            spec.compile()
        except (ValueError, RuntimeError):
            yield file.name


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
