"""What a text says by Appendix A, and the same said of our models: plain values that can be compared."""

from collections.abc import Callable
from typing import Any

import pytest

from onika.model.application import AppFlow, Application, Branch, Icon, Step
from onika.model.camera import CameraBlock
from onika.model.configuration import Configuration
from onika.model.onikon import Onikon
from onika.model.own_lines import OwnLines
from onika.model.picture import Picture
from onika.model.preferences import Preferences
from onika.model.robot import RobotArm, RobotAxes, RobotBase, RobotDevice, RobotText, SensorBlock
from onika.model.syntax import Syntax
from onika.model.task import Task, TaskType
from onika.model.world import Block, LampBlock, PartBlock, PlaceBlock, Spot, SwitchBlock, WorldText

from . import application, configuration, icon, installation, parameters, workcell

Plain = Any


def types_of(syntax: Syntax) -> icon.Types:
    return {kind.name.lower(): [(item.type.value, item.count) for item in kind.items] for kind in syntax.types}


def naive_readers(syntax: Syntax) -> dict[str, Callable[[str], Plain]]:
    """By the name of the format."""
    types = types_of(syntax)
    return {
        "task": parameters.read,
        "configuration": configuration.read,
        "onikon": lambda text: icon.read(text, types),
        "application": lambda text: application.read(text, types),
        "syntax": installation.syntax,
        "preferences": lambda text: {**plain_preferences(Preferences()), **installation.preferences(text)},
        "buttons": installation.buttons,
        "picture": installation.picture,
        "robot": workcell.robot,
        "world": workcell.world,
    }


def plain(model: Any) -> Plain:
    """Our model as the naive readers say it."""
    match model:
        case (Task() as task, bool(gives_period)):
            return _task(task, gives_period)
        case Configuration():
            return _configuration(model)
        case Onikon():
            return _onikon(model)
        case Application():
            kind = "parallel" if model.is_parallel else "conditional"
            return {"APPLTYPE": kind, "flows": [_flow(flow) for flow in model.flows]}
        case Syntax():
            return _syntax(model)
        case Preferences():
            return plain_preferences(model)
        case Picture():
            return list(model.rows)
        case RobotText():
            return _robot(model)
        case WorldText():
            return _world(model)
        case None:
            return None
        case _:
            return [(button.name, button.command, button.spawns_terminal) for button in model]


def _task(task: Task, gives_period: bool) -> dict[str, Any]:
    result: dict[str, Any] = {"MODULE": task.module, "DESC": task.description, "SVARALIAS": dict(task.aliases)}
    ports = (task.inconst, task.outconst, task.invar, task.outvar)
    result |= {keyword: list(names) for keyword, names in zip(parameters.PORTS, ports, strict=True)}
    result["TASKTYPE"] = task.type.value
    if task.type is not TaskType.APERIODIC:
        assert task.frequency
        result["RATE"] = (
            ("PERIOD", pytest.approx(1 / task.frequency, rel=1e-12)) if gives_period else ("FREQ", task.frequency)
        )
    if task.object_type is not None:
        result["OBJECT"] = task.object_type
        if task.more_targets:
            result["TARGET"] = list(task.more_targets)
    result["LOCAL"] = [(line.key, list(line.words)) for line in task.local]
    return result


def _configuration(result: Configuration) -> dict[str, Any]:
    tasks = [
        (item.task, (item.x, item.y), item.in_left, item.frequency, item.rtpu, item.file, _own_lines(item.own))
        for item in result.placed
    ]
    loci = [
        (at.svar, (at.x, at.y), [at.conns, at.inconst, at.outconst, at.invar, at.outvar, at.double_in], at.show)
        for at in result.loci
    ]
    return {"tasks": tasks, "loci": loci, "groups": [[group.name, *group.tasks] for group in result.groups]}


def _own_lines(own: OwnLines) -> dict[str, Any]:
    local = {line.key: list(line.words) for line in own.local}
    return {"SVARALIAS": dict(own.aliases), "LOCAL": local, "NOLOCAL": list(own.without)}


def _onikon(onikon: Onikon) -> dict[str, Any]:
    values = [list(item) for item in onikon.values]
    return {
        "ONIKON": onikon.type.lower(),
        "TARGET": [kind.lower() for kind in onikon.more_targets],
        "DESC": onikon.description,
        "DESCIN": dict(onikon.words),
        "ARM": onikon.arm,
        "UI": values,
        "PICT": list(onikon.picture.rows),
    }


def _flow(app_flow: AppFlow) -> list[Any]:
    return [_step(step) for step in app_flow.steps]


def _step(step: Step) -> Any:
    if isinstance(step, Branch):
        return {"BRANCH": [_flow(flow) for flow in step.flows], "IF": list(step.conditions)}
    return _icon(step) if isinstance(step, Icon) else "hole"


def _icon(result: Icon) -> dict[str, Any]:
    marks = {"ROUTINE": result.onikon.name, "MARKER": result.marker, "MARKERIF": result.marker_if}
    marks |= {"SYNCHTAG": result.synch_tag, "WHILETAG": result.while_tag, "WHILETEST": result.while_test}
    return {**marks, "WHILEIF": result.while_if, **_onikon(result.onikon)}


def _syntax(syntax: Syntax) -> dict[str, Any]:
    types = [
        (
            kind.name,
            kind.left_edge,
            kind.right_edge,
            [(item.name, item.type.value, item.count, item.dimension, item.each) for item in kind.items],
        )
        for kind in syntax.types
    ]
    edges = [(edge.number, list(edge.rgb), [move for pair in edge.vertices for move in pair]) for edge in syntax.edges]
    return {"types": types, "edges": edges}


def plain_preferences(of: Preferences) -> dict[str, Any]:
    lengths = (of.line_length, of.min_size, of.min_pin_separation, of.step_size, of.pin_length)
    lengths += (of.connection_separation, of.locus_size, of.hit_tolerance)
    shown = (of.show_inconst, of.show_outconst, of.show_invar, of.show_outvar)
    windows = [[at.x, at.y, at.height, at.width] for at in (of.library, of.canvas, of.dictionary, of.workspace)]
    spots = [[at.x, at.y] for at in (of.status, of.variables, of.main, of.buttons)]
    return {
        **dict(zip(installation.LENGTHS, lengths, strict=True)),
        **dict(zip(installation.SHOWN, shown, strict=True)),
        **dict(zip(installation.WINDOWS, windows, strict=True)),
        **dict(zip(installation.SPOTS, spots, strict=True)),
        "RATE": "period" if of.shows_period else "frequency",
        "STATINFO": list(of.status_columns),
    }


def _robot(robot: RobotText) -> dict[str, Any]:
    attached = {"LINKS": list(robot.links), "HAND": robot.hand, "ON": robot.on}
    cameras = [("CAMERA", camera.name, _camera(camera)) for camera in robot.cameras]
    devices = [_device(device) for device in robot.devices]
    head = {"DESC": robot.description, "KIND": robot.given_kind, "FILE": robot.file}
    return {**head, **attached, "CAMERAS": cameras, "devices": devices}


def _device(device: RobotDevice) -> tuple[str, str, dict[str, Any]]:
    if isinstance(device, RobotArm):
        lines: dict[str, Any] = {"TOOL": (device.tool, list(device.offset)), "APPROACH": device.approach}
        lines |= {"FINGERS": device.fingers, "FROM": device.start, "DRIVE": device.drive, "HOME": list(device.home)}
        lines |= {"SPEED": list(device.speed), "TORQUE": list(device.torque), "ARMATURE": device.armature}
        lines["GAINS"] = device.gains and (list(device.gains[0]), list(device.gains[1]))
        return "ARM", device.name, lines
    if isinstance(device, RobotAxes):
        return "AXES", device.name, {"MOVES": list(device.moves), "DRIVE": device.drive}
    if isinstance(device, RobotBase):
        lines = {"WHEELS": list(device.wheels), "SIZES": (device.radius, device.track), "SLIDES": list(device.slides)}
        return "BASE", device.name, {**lines, "SPEED": device.speed}
    if isinstance(device, SensorBlock):
        return "SENSOR", device.name, _sensor(device)
    lines = {
        "MOVES": list(device.moves),
        "DRIVE": device.drive,
        "OPEN": list(device.open),
        "CLOSED": list(device.closed),
    }
    return "GRIPPER", device.name, {**lines, "FORCE": list(device.force)}


def _sensor(sensor: SensorBlock) -> dict[str, Any]:
    return {"READS": list(sensor.reads), "POSE": sensor.body}


def _camera(camera: CameraBlock) -> dict[str, Any]:
    lines = {"VIEW": camera.view, "ON": camera.on, "AT": list(camera.at), "LOOKS": list(camera.looks)}
    return {**lines, "DEVICE": camera.device, "SIZE": camera.size, "LENS": camera.lens, "RATE": camera.rate}


def _world(world: WorldText) -> dict[str, Any]:
    head = {"DESC": world.description, "STEP": world.step_s, "GRAVITY": world.gravity, "CONTACT": world.contact}
    return {**head, "FLOOR": world.floor, "blocks": [_block(block) for block in world.blocks]}


def _block(block: Block) -> tuple[str, str, dict[str, Any]]:
    match block:
        case PartBlock():
            lines: dict[str, Any] = {"FILE": block.file, **_spot(block.spot), "FREE": block.free}
            return "PART", block.name, {**lines, "NAME": dict(block.names)}
        case PlaceBlock():
            lines = {"EMPTY": block.is_empty, "ROBOTS": list(block.robots), "HAND": block.hand and list(block.hand)}
            titles = {"NAME": dict(block.names), "HANDNAME": dict(block.hand_names)}
            return "PLACE", block.name, {**lines, **_spot(block.spot), **titles}
        case SwitchBlock():
            return (
                "SWITCH",
                block.name,
                {
                    "NEAR": block.near,
                    "PRESSED": block.pressed,
                    "ABOVE": block.above,
                    "TOUCHED": block.is_touched,
                },
            )
        case LampBlock():
            lines = {"WHEN": list(block.when), "SHINES": list(block.shines), "GLOWS": list(block.glows)}
            return "LAMP", block.name, {**lines, "NAME": dict(block.names)}
        case SensorBlock():
            return "SENSOR", block.name, _sensor(block)
        case CameraBlock():
            return "CAMERA", block.name, _camera(block)
    return "BUTTON", block.name, {"STOPS": list(block.stops)}


def _spot(spot: Spot) -> dict[str, Any]:
    return {"AT": list(spot.at), "ON": spot.on}
