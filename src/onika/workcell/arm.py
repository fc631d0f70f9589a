"""An arm as a part: its links from the table of constants, a column to stand on, a motor at each joint, a hand."""

from collections.abc import Callable
from dataclasses import dataclass

from onika.laws.chain import Link, kinds_of, links, text_of
from onika.laws.frames import Array
from onika.laws.robot import Robot
from onika.workcell.gripper import GripperPart
from onika.workcell.part import TouchSpot, WorldPart, placed

SHOULDER_M = 0.6718
"""Height of frame 0 above the floor."""


@dataclass(frozen=True, slots=True)
class ArmKind:
    """A kind of arm: its constants and, for each link in its own frame and for the column, the shapes.

    `touching` says what touches, `drawn` what is looked at, `column(drawn, touch)` either.
    """

    robot: Robot
    touching: Callable[[TouchSpot], tuple[str, ...]]
    drawn: Callable[[], tuple[str, ...]]
    column: Callable[[bool, TouchSpot], str]


def arm(kind: ArmKind, name: str, base: Array, touch: TouchSpot, hand: GripperPart, drawn: bool) -> WorldPart:
    """An arm with joints `name.joint1` ..., frame 0 at `base` (pose in the world), carrying `hand`."""
    robot = kind.robot
    inner = hand.body(touch, drawn)
    shapes = kind.drawn() if drawn else kind.touching(touch)
    chain = links(robot.DH, kinds_of(robot.DH))
    for k in reversed(range(robot.NDOF)):
        inner = _body(robot, name, k, chain[k], shapes[k] + inner)
    bodies = f'<body name="{name}.base" {placed(base)}>{kind.column(drawn, touch)}{inner}</body>'
    if drawn:
        return WorldPart(bodies)
    return WorldPart(
        bodies,
        actuators="".join(_motor(robot, name, k) for k in range(robot.NDOF)) + hand.actuators(),
        equalities=hand.equalities(),
        sensors=hand.sensors(),
    )


def rod(x0: float, y0: float, z0: float, x1: float, y1: float, z1: float, radius: float, material: str) -> str:
    """A drawn cylinder from one point to another (m)."""
    return f'<geom type="cylinder" size="{radius}" fromto="{x0} {y0} {z0} {x1} {y1} {z1}" material="{material}"/>'


def capsule(x0: float, y0: float, z0: float, x1: float, y1: float, z1: float, radius: float, material: str) -> str:
    """A drawn cylinder with round ends from one point to another (m)."""
    return f'<geom type="capsule" size="{radius}" fromto="{x0} {y0} {z0} {x1} {y1} {z1}" material="{material}"/>'


def _body(robot: Robot, name: str, k: int, link: Link, inner: str) -> str:
    row = robot.DYN[k]
    return (
        f'<body name="{name}.link{k + 1}" pos="{text_of(link.position)}" quat="{text_of(link.quaternion)}">'
        f'<inertial pos="{text_of(row[1:4])}" mass="{float(row[0])}" diaginertia="{text_of(row[4:7])}"/>'
        f'<joint name="{name}.joint{k + 1}" type="{"slide" if link.slides else "hinge"}" axis="{text_of(link.axis)}" '
        f'pos="{text_of(link.anchor)}" range="{float(robot.QMIN[k])} {float(robot.QMAX[k])}" '
        f'armature="{float(row[7])}" damping="{float(row[8])}"/>{inner}</body>'
    )


def _motor(robot: Robot, name: str, k: int) -> str:
    most = float(robot.TAUMAX[k])
    return f'<motor name="{name}.motor{k + 1}" joint="{name}.joint{k + 1}" ctrlrange="-{most} {most}"/>'
