"""Where the parts of a world that move are: at the start, never twice alike, and how far from there later."""

import math
from collections.abc import Callable, Collection, Iterator, Sequence

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.world import PartBlock
from onika.ring.displacement import Displacement
from onika.words.reason import Reason
from onika.workcell.composed.usable_parts import FREE_JOINT, prefix_of
from onika.workcell.plant import Plant

_NEAR_M = 0.004  # how far a part may be from its place and still stand there
_TURNED_RAD = 0.05  # how far it may be turned and still stand as it stood


def free_parts(parts: Sequence[PartBlock], plant: Plant, qpos: Array) -> Iterator[tuple[PartBlock, Array]]:
    """The parts that move, each with where it is: place (m) and quaternion (w, x, y, z)."""
    for part in parts:
        joint = mujoco.mj_name2id(plant.model, mujoco.mjtObj.mjOBJ_JOINT, prefix_of(part.name) + FREE_JOINT)
        if part.free is not None and joint >= 0:
            first = int(plant.model.jnt_qposadr[joint])
            yield part, qpos[first : first + 7]


def places(parts: Sequence[PartBlock], plant: Plant, qpos: Array, called: Callable[[str], Reason]) -> Iterator[Reason]:
    """Where they are, in sentences; `called` says what a part is called."""
    for part, at in free_parts(parts, plant, qpos):
        x, y, z = (100.0 * at[:3]).tolist()
        yield Reason.of("workcell.part_place", part=called(part.name), x_cm=x, y_cm=y, z_cm=z)


def displaced(
    parts: Sequence[PartBlock], plant: Plant, called: Callable[[str], Reason], held: Collection[str]
) -> Iterator[Displacement]:
    """Those that are not where they began, or not as they stood there; not those that are held."""
    started = {part.name: at for part, at in free_parts(parts, plant, plant.model.qpos0)}
    for part, at in free_parts(parts, plant, plant.data.qpos):
        away = float(np.linalg.norm(at[:3] - started[part.name][:3]))
        if part.name in held:
            continue
        if away > _NEAR_M:
            yield Displacement(Reason.of("workcell.part_away", part=called(part.name), cm=100 * away))
        elif abs(float(at[3:] @ started[part.name][3:])) < math.cos(_TURNED_RAD / 2.0):
            yield Displacement(Reason.of("workcell.part_turned", part=called(part.name)))


def offsets(parts: Sequence[PartBlock], seed: int | None) -> dict[str, tuple[float, float]]:
    """How far parts stand from their spots that never stand twice alike."""
    if seed is None:
        return {}
    random = np.random.default_rng(seed)
    drawn = {part.name: random.uniform(-(part.free or 0.0), part.free or 0.0, 2) for part in parts}
    return {name: (float(offset[0]), float(offset[1])) for name, offset in drawn.items()}
