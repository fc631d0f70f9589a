"""The file of a robot, `robot/NAME.robot`: a format of our own (requirement X19)."""

from collections.abc import Sequence

from onika.files import base_block, camera as camera_block, sensor_block
from onika.files.block_words import BlockWords, number_row, text_row
from onika.files.layout import carry_comments
from onika.files.line import FileLine, row, show_number, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.model.robot import (
    AXIS_WORDS,
    DRIVES,
    GRIPPER_DRIVES,
    Numbers,
    RobotArm,
    RobotAxes,
    RobotBase,
    RobotDevice,
    RobotGripper,
    RobotText,
    SensorBlock,
)
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".robot"

_HEAD = (
    KeywordSlot("VERSION"),
    KeywordSlot("DESC", Need.OPTIONAL),
    KeywordSlot("KIND", Need.OPTIONAL),
    KeywordSlot("FILE"),
    KeywordSlot("LINKS", Need.OPTIONAL),
    KeywordSlot("HAND", Need.OPTIONAL),
    KeywordSlot("ON", Need.OPTIONAL),
)
_ARM = (
    KeywordSlot("ARM"),
    KeywordSlot("TOOL"),
    *(
        KeywordSlot(keyword, Need.OPTIONAL)
        for keyword in ("APPROACH", "FINGERS", "FROM", "DRIVE", "HOME", "SPEED", "TORQUE", "KP", "KD", "ARMATURE")
    ),
)
_AXES = (KeywordSlot("AXES"), KeywordSlot("MOVES"), KeywordSlot("DRIVE", Need.OPTIONAL))
_GRIPPER = (
    KeywordSlot("GRIPPER"),
    KeywordSlot("MOVES"),
    KeywordSlot("DRIVE", Need.OPTIONAL),
    KeywordSlot("OPEN"),
    KeywordSlot("CLOSED"),
    KeywordSlot("FORCE", Need.OPTIONAL),
)
_SPEED_LEAST = 1e-6


def read(text: str, name: str, place_file: str) -> tuple[RobotText | None, tuple[Fault, ...]]:
    """The robot `name` of a text; with any fault it is left out."""
    reading = TextReading(place_file, Reason.of("files.robot_left_out"))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *every = split(reading.lines, {"ARM", "AXES", "GRIPPER", "BASE", "SENSOR", camera_block.HEAD})
    blocks = [block for block in every if block[0].keyword != camera_block.HEAD]
    words = BlockWords(head, _HEAD, reading)
    if reading.lines and not reading.is_extended:
        reading.fault(reading.lines[0].number, Reason.of("files.version_of_ours", extended=EXTENDED))
    hand, on = words.file("HAND"), words.word("ON", Reason.of("files.name_of_site"))
    links = words.words("LINKS", Reason.of("files.names_of_models"), is_each_once=False)
    attached = "LINKS" if words.has("LINKS") else "HAND"
    if words.has(attached) != words.has("ON"):
        words.wrong(attached if words.has(attached) else "ON", Reason.of("files.hand_and_site"))
    devices = tuple(_device(block, reading) for block in blocks)
    seen = [BlockWords(block, camera_block.SLOTS, reading) for block in every if block not in blocks]
    cameras = tuple(camera_block.camera(block) for block in seen)
    _check_twice(every, reading)
    _check_moves(blocks, devices, reading)
    robot = RobotText(
        name,
        words.file("FILE"),
        words.text("DESC"),
        hand,
        on,
        devices,
        words.lines,
        links,
        cameras=cameras,
        given_kind=words.name("KIND") if words.has("KIND") else "",
    )
    return (None if reading.broken else robot), reading.faults


def write(robot: RobotText, former: str = "") -> str:
    """The text of a robot, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED), text_row("DESC", robot.description)]
    parts += [row("KIND", robot.given_kind)] if robot.given_kind else []
    parts += [row("FILE", robot.file)]
    parts += [row("LINKS", *robot.links)] if robot.links else []
    parts += [row("HAND", robot.hand)] if robot.hand else []
    parts += [row("ON", robot.on)] if robot.on else []
    parts += ["\n" + _show(device) for device in robot.devices]
    parts += ["\n" + camera_block.show(camera) for camera in robot.cameras]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show(device: RobotDevice) -> str:
    match device:
        case RobotArm():
            return _show_arm(device)
        case RobotAxes():
            return row("AXES", device.name) + row("MOVES", *device.moves) + _show_drive(device.drive)
        case RobotBase():
            return base_block.show_base(device)
        case SensorBlock():
            return sensor_block.show_sensor(device)
        case RobotGripper():
            return _show_gripper(device)


def _show_gripper(device: RobotGripper) -> str:
    parts = [row("GRIPPER", device.name), row("MOVES", *device.moves)]
    parts += [] if device.drive == GRIPPER_DRIVES[0] else [row("DRIVE", device.drive)]
    parts += [number_row("OPEN", device.open), number_row("CLOSED", device.closed)]
    return "".join(parts) + (row("FORCE", *device.force) if device.force else "")


def _show_arm(arm: RobotArm) -> str:
    offset = map(show_number, arm.offset) if any(arm.offset) else ()
    parts = [row("ARM", arm.name), row("TOOL", arm.tool, *offset)]
    parts += [row("APPROACH", arm.approach)] if arm.approach != "z" else []
    parts += [row("FINGERS", arm.fingers)] if arm.fingers != "y" else []
    parts += [row("FROM", arm.start)] if arm.start else []
    parts += [_show_drive(arm.drive)]
    stiffness, damping = arm.gains or ((), ())
    rows = (("HOME", arm.home), ("SPEED", arm.speed), ("TORQUE", arm.torque), ("KP", stiffness), ("KD", damping))
    for keyword, numbers in rows:
        parts += [number_row(keyword, numbers)] if numbers else []
    parts += [] if arm.armature is None else [number_row("ARMATURE", (arm.armature,))]
    return "".join(parts)


def _show_drive(drive: str) -> str:
    return "" if drive == DRIVES[0] else row("DRIVE", drive)


def _device(block: Sequence[FileLine], reading: TextReading) -> RobotDevice:
    match block[0].keyword:
        case "ARM":
            return _arm(BlockWords(block, _ARM, reading))
        case "AXES":
            words = BlockWords(block, _AXES, reading)
            return RobotAxes(words.name("AXES"), _moves(words), words.choice("DRIVE", DRIVES), words.lines)
        case "BASE":
            return base_block.read_base(BlockWords(block, base_block.SLOTS, reading))
        case "SENSOR":
            return sensor_block.read_sensor(BlockWords(block, sensor_block.SLOTS, reading))
    return _gripper(BlockWords(block, _GRIPPER, reading))


def _moves(words: BlockWords) -> tuple[str, ...]:
    return words.words("MOVES", Reason.of("files.names_of_actuators"))


def _arm(words: BlockWords) -> RobotArm:
    tool, offset = words.named_numbers("TOOL", Reason.of("files.tool_words"), 1, (0, 3))
    approach = words.choice("APPROACH", ("z", *(axis for axis in AXIS_WORDS if axis != "z")))
    fingers = words.choice("FINGERS", ("y", *(axis for axis in AXIS_WORDS if axis != "y")))
    if approach[-1] == fingers[-1]:
        words.wrong("FINGERS" if words.has("FINGERS") else "APPROACH", Reason.of("files.axes_alike", axis=fingers[-1]))
    highest = Reason.of("files.numbers_above_0")
    armature = words.number("ARMATURE", Reason.of("files.number_from_0"), 0.0, 0.0) if words.has("ARMATURE") else None
    drive = words.choice("DRIVE", DRIVES)
    return RobotArm(
        words.name("ARM"),
        tool[0] if tool else "",
        offset or (0.0, 0.0, 0.0),
        approach,
        fingers,
        words.word("FROM", Reason.of("files.name_of_body")),
        drive,
        words.numbers("HOME", Reason.of("files.joint_values"), 0),
        words.numbers("SPEED", highest, 0, low=_SPEED_LEAST),
        words.numbers("TORQUE", highest, 0, low=_SPEED_LEAST),
        armature,
        words.lines,
        _gains(words, drive),
    )


def _gains(words: BlockWords, drive: str) -> tuple[Numbers, Numbers] | None:
    """The gains by which a drive that takes torques holds: both lines, or none."""
    meaning = Reason.of("files.numbers_above_0")
    stiffness, damping = (words.numbers(keyword, meaning, 0, low=_SPEED_LEAST) for keyword in ("KP", "KD"))
    if words.has("KP") != words.has("KD"):
        words.wrong("KP" if words.has("KP") else "KD", Reason.of("files.gains_both"))
    elif words.has("KP") and drive != "torque":
        words.wrong("KP", Reason.of("files.gains_of_torques"))
    return (stiffness, damping) if stiffness and damping else None


def _gripper(words: BlockWords) -> RobotGripper:
    meaning = Reason.of("files.signal_and_width")
    opened, closed = words.numbers("OPEN", meaning, 2), words.numbers("CLOSED", meaning, 2)
    if opened and closed:
        if opened[0] == closed[0]:
            words.wrong("CLOSED", Reason.of("files.signals_alike", signal=closed[0]))
        if opened[1] <= closed[1] or closed[1] < 0:
            words.wrong("CLOSED", Reason.of("files.widths_reversed", closed=closed[1], open=opened[1]))
    force = words.words("FORCE", Reason.of("files.names_of_sensors"))
    drive = words.choice("DRIVE", GRIPPER_DRIVES)
    return RobotGripper(words.name("GRIPPER"), _moves(words), opened, closed, force, words.lines, drive)


def _check_twice(blocks: Sequence[Sequence[FileLine]], reading: TextReading) -> None:
    """Each name of a device once."""
    seen: dict[str, int] = {}
    for block in blocks:
        first = seen.setdefault(block[0].rest, block[0].number)
        if first != block[0].number:
            reading.fault(block[0].number, Reason.of("files.every_name_once", given=str(block[0])))


def _check_moves(blocks: Sequence[Sequence[FileLine]], devices: Sequence[RobotDevice], reading: TextReading) -> None:
    """Each actuator in one device."""
    homes: dict[str, str] = {}
    for block, device in zip(blocks, devices, strict=True):
        keyword, actuators = _driven(device)
        for actuator in actuators:
            other = homes.setdefault(actuator, device.name)
            if other != device.name:
                number = device.lines.get(keyword, block[0].number)
                reason = Reason.of("files.actuator_twice", actuator=actuator, device=device.name, other=other)
                reading.fault(number, reason)


def _driven(device: RobotDevice) -> tuple[str, tuple[str, ...]]:
    """The actuators that a device names, and the line that does."""
    match device:
        case RobotAxes() | RobotGripper():
            return "MOVES", device.moves
        case RobotBase(wheels=()):
            return "SLIDES", device.slides
        case RobotBase():
            return "WHEELS", device.wheels
        case RobotArm() | SensorBlock():
            return "", ()
