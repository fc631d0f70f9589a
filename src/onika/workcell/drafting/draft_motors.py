"""Joints of a model that would need motors of their own: those of an arm of which only the hand is driven (X19)."""

from collections.abc import Iterator
from typing import Any

import mujoco

from onika.workcell.drafting.draft_chain import MOVING, DraftChain, bearers, couplings, driven_joints

_LEAST = 2
"""So many joints that nothing drives are an arm that bears a driven finger, and not what a machine hangs at."""


def undriven(model: Any, chain: DraftChain | None) -> tuple[str, ...]:
    """The names of the joints that nothing drives, where there is no arm without them; none where there is one.

    What is taken for an arm is none where its only joint goes with another one, as a finger does, and an arm bears it.
    """
    coupled = {joint for pair in couplings(model) for joint in pair}
    moved = driven_joints(model) | {*_drawn(model)} | coupled
    loose = [k for k in range(model.njnt) if int(model.jnt_type[k]) in MOVING and k not in moved]
    if chain is not None and not (len(chain.joints) == 1 and coupled.issuperset(chain.joints)):
        return ()
    if chain is not None:
        bodies = bearers(model, chain.last)
        loose = [joint for joint in loose if int(model.jnt_bodyid[joint]) in bodies]
    names = tuple(model.joint(joint).name for joint in loose)
    is_arm = len(names) >= _LEAST and all(names) and model.nu > 0
    return names if is_arm else ()


def _drawn(model: Any) -> Iterator[int]:
    """The joints at which a tendon stands that an actuator draws."""
    for actuator in range(model.nu):
        if int(model.actuator_trntype[actuator]) == int(mujoco.mjtTrn.mjTRN_TENDON):
            tendon = int(model.actuator_trnid[actuator][0])
            first, count = int(model.tendon_adr[tendon]), int(model.tendon_num[tendon])
            for wrap in range(first, first + count):
                if int(model.wrap_type[wrap]) == int(mujoco.mjtWrap.mjWRAP_JOINT):
                    yield int(model.wrap_objid[wrap])
