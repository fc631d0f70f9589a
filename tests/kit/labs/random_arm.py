"""Arms that nobody has built: 4 to 7 joints about any axes, with masses and limits drawn, as a base directory."""

import random
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from onika.desk.plan.robot_files import create_robot
from onika.store.site import open_site

NAME = "drawn"
"""What the robot, its world and the task of its arm are called."""

_DRIVES = {
    "arm_pos": ("", "Q_REF Q^_REF"),
    "arm_vel": ("DRIVE       velocity\n", "Q^_REF"),
    "arm_tau": ("DRIVE       torque\n", "TAU_REF"),
}
"""Modules of any arm, with what the description says for each and what it takes."""


@dataclass(frozen=True)
class RandomArm:
    """An arm in files, and the limits of its joints: rad, m where one slides."""

    module: str
    limits: tuple[tuple[float, float], ...]


def random_arm(path: Path, seed: int) -> RandomArm:
    """Draw an arm and write it, with its world and task, into a base directory; the same seed draws the same one."""
    draw = random.Random(seed)
    module = sorted(_DRIVES)[seed % len(_DRIVES)]
    slides = [draw.random() < 0.15 for _ in range(draw.randint(4, 7))]
    limits = tuple(_limits(draw, is_slide) for is_slide in slides)
    model = path / "drawn" / f"{NAME}.xml"
    model.parent.mkdir(parents=True)
    model.write_text(_model(draw, slides, limits))
    create_robot(model, path, open_site((), {}, None))
    drive, takes = _DRIVES[module]
    _changed(path / "robot" / f"{NAME}.robot", "SPEED ", f"{drive}SPEED ")
    _changed(path / "module" / f"{NAME}.rmod", "arm_pos", module)
    _changed(path / "module" / f"{NAME}.rmod", "Q_REF Q^_REF", takes)
    return RandomArm(module, limits)


def _limits(draw: random.Random, is_slide: bool) -> tuple[float, float]:
    if is_slide:
        return round(-draw.uniform(0.05, 0.3), 3), round(draw.uniform(0.05, 0.3), 3)
    return round(-draw.uniform(0.6, 3.0), 3), round(draw.uniform(0.6, 3.0), 3)


def _model(draw: random.Random, slides: list[bool], limits: tuple[tuple[float, float], ...]) -> str:
    """A chain in MJCF, whose links meet nothing."""
    bodies = ""
    for number, (is_slide, (low, high)) in enumerate(zip(slides, limits, strict=True)):
        axis = _numbers(draw.uniform(-1.0, 1.0) for _ in range(3))
        place = _numbers([draw.uniform(-0.1, 0.1), draw.uniform(-0.1, 0.1), draw.uniform(0.1, 0.35)])
        turn = _numbers(draw.uniform(-1.0, 1.0) for _ in range(4))
        kind = "slide" if is_slide else "hinge"
        strength = draw.uniform(60.0, 200.0)
        bodies += (
            f'<body name="link{number}" pos="{place}" quat="{turn}">'
            f'<joint name="joint{number}" type="{kind}" axis="{axis}" range="{low} {high}" damping="0.5"'
            f' armature="{draw.uniform(0.01, 0.2):.3f}" actuatorfrcrange="{-strength:.1f} {strength:.1f}"/>'
            f'<geom type="capsule" size="0.03" fromto="0 0 0 0 0 0.15" mass="{draw.uniform(0.2, 3.0):.3f}"'
            ' contype="0" conaffinity="0"/>'
        )
    site = '<site name="tip" pos="0 0 0.15"/>'
    return (
        '<mujoco><compiler angle="radian"/><worldbody>'
        + bodies
        + site
        + "</body>" * len(slides)
        + "</worldbody></mujoco>"
    )


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{value:.4f}" for value in values)


def _changed(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    if old not in text:
        raise ValueError(f"expected {old!r} in {path}")
    path.write_text(text.replace(old, new, 1))
