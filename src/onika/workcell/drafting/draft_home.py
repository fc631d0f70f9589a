"""Where an arm begins of whose home its model says nothing."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.words.reason import Reason
from onika.workcell.drafting.draft_chain import DraftChain

_DEEP_M = 0.001
_INWARD = 0.1  # so much of its range a joint keeps off its limits
_TOWARDS_MIDDLE = (0.25, 0.5, 0.75, 1.0)
_TRIES = 60
_ENDLESS = np.pi / 2.0  # so far a joint without limits is turned (rad)


@dataclass(frozen=True, slots=True, eq=False)
class DraftHome:
    """The home of an arm (rad; m where a joint slides) and where it comes from (X19)."""

    values: Array
    origin: Reason
    is_usual: bool = True
    """It is what stands for a HOME that is not said."""


def draft_home(model: Any, chain: DraftChain, *, is_apart: bool) -> DraftHome:
    """The keyframe `home`; else zero; else a posture where the arm meets nothing, or the least.

    `is_apart`: bodies that touch at home are kept apart anyhow, as those of a URDF.
    """
    at = [int(model.jnt_qposadr[joint]) for joint in chain.joints]
    keys = [k for k in range(model.nkey) if model.key(k).name == "home"]
    lowest, highest = _limits(model, chain)
    if keys:
        return DraftHome(np.clip(model.key_qpos[keys[0]][at], lowest, highest), Reason.of("workcell.draft_home_key"))
    zero: Array = np.clip(np.zeros(len(at)), lowest, highest)
    least = 0 if is_apart else _meetings(model, chain, zero)
    best = zero
    for values in _postures(zero, lowest, highest):
        if not least:
            break
        count = _meetings(model, chain, values)
        if count < least:
            best, least = values, count
    if best is zero:
        return DraftHome(zero, Reason.of("workcell.draft_home_zero"))
    return DraftHome(best, Reason.of("workcell.draft_home_free"), is_usual=False)


def _limits(model: Any, chain: DraftChain) -> tuple[Array, Array]:
    lowest, highest = np.full(len(chain.joints), -np.inf), np.full(len(chain.joints), np.inf)
    for k, joint in enumerate(chain.joints):
        if model.jnt_limited[joint]:
            lowest[k], highest[k] = model.jnt_range[joint]
    return lowest, highest


def _postures(zero: Array, lowest: Array, highest: Array) -> Iterator[Array]:
    """From zero inwards, then anywhere: the same ones for the same arm."""
    least, most = np.maximum(lowest, -_ENDLESS), np.minimum(highest, _ENDLESS)
    least, most = np.where(np.isfinite(lowest), lowest, least), np.where(np.isfinite(highest), highest, most)
    spare = _INWARD * (most - least)
    inside: Array = np.clip(zero, least + spare, most - spare)
    yield _rounded(inside, least, most)
    for part in _TOWARDS_MIDDLE:
        yield _rounded(inside + part * ((least + most) / 2.0 - inside), least, most)
    random = np.random.default_rng(1)
    for _ in range(_TRIES):
        yield _rounded(random.uniform(least + spare, most - spare), least, most)


def _rounded(values: Array, least: Array, most: Array) -> Array:
    rounded: Array = np.clip(np.round(values, 3), least, most)
    return rounded


def _meetings(model: Any, chain: DraftChain, values: Array) -> int:
    """How often what the arm moves reaches into something, but for what bears it."""
    data = mujoco.MjData(model)
    data.qpos[[int(model.jnt_qposadr[joint]) for joint in chain.joints]] = values
    mujoco.mj_forward(model, data)
    first = int(model.jnt_bodyid[chain.joints[0]])
    count = 0
    for contact in np.flatnonzero(data.contact.dist < -_DEEP_M).tolist():
        one, other = sorted(int(model.geom_bodyid[geom]) for geom in data.contact.geom[contact])
        is_moved = _stands_on(model, one, first) or _stands_on(model, other, first)
        count += is_moved and int(model.body_parentid[other]) != one
    return count


def _stands_on(model: Any, body: int, first: int) -> bool:
    while body > first:
        body = int(model.body_parentid[body])
    return body == first
