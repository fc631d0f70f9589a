"""What an arm says of itself as a device, as the constants that its hardware task publishes.

An identity is flat: rows of doubles and texts. SCREW, LINK, PARENT, TOOL, BASE, QMIN, QMAX, Q^_MAX, TAUMAX and HOME
have the units and frames of the constants of these names, ROBOT is its kind, DRIVE what a command consists of:
position, velocity, torque, or posture where no forces act (`WITHOUT_FORCES`).
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from onika.laws.frames import as_array
from onika.laws.screws import parents, screws
from onika.laws.sentence import LawSentence

Identity = Mapping[str, Any]

WITHOUT_FORCES = "posture"
"""What drives a device of joints in a world without forces: joint values, where it then is."""

_ROWS = ("QMIN", "QMAX", "Q^_MAX", "HOME")
_ARM_ROWS = (*_ROWS, "TAUMAX")
_POSES = ("TOOL", "BASE")


def arm_constants(identity: Identity) -> dict[str, Any]:
    """The constants of an arm, by the names of the OUTCONSTs; raises ValueError where it does not say them."""
    if "SCREW" not in identity:
        raise ValueError(_no_arm(identity))
    _need(identity, ("LINK", *_ARM_ROWS, *_POSES))
    screw = screws(identity["SCREW"])
    n = len(screw)
    return {
        "NDOF": n,
        "SCREW": screw,
        "LINK": as_array(identity["LINK"], (n, 13)),
        "PARENT": parents(identity.get("PARENT"), n),
        "LOAD": np.zeros(4),
        "ROBOT": str(identity.get("ROBOT", "")),
        **{name: as_array(identity[name], (4, 4)) for name in _POSES},
        **{name: as_array(identity[name], (n,)) for name in _ARM_ROWS},
    }


def axes_constants(identity: Identity) -> dict[str, Any]:
    """The constants of axes without a chain, by the names of the OUTCONSTs; raises ValueError for missing limits."""
    _need(identity, _ROWS)
    n = np.size(identity["QMIN"])
    rows = {name: as_array(identity[name], (n,)) for name in _ROWS}
    return {"NDOF": n, "ROBOT": str(identity.get("ROBOT", "")), **rows}


def driven_otherwise(identity: Identity, drive: str) -> LawSentence | None:
    """Why an arm or axes are not driven by `drive`; None where they are."""
    found = str(identity.get("DRIVE", ""))
    if found == drive:
        return None
    return LawSentence(
        "laws.drive_other",
        "expected a device that is driven by {drive}, found one driven by {other}",
        drive=drive,
        other=found or "-",
    )


def _need(identity: Identity, names: tuple[str, ...]) -> None:
    missing = [name for name in names if name not in identity]
    if missing:
        raise ValueError(
            LawSentence(
                "laws.arm_lacks", "expected the arm behind the device to say its {names}", names=" ".join(missing)
            )
        )


def _no_arm(identity: Identity) -> LawSentence:
    robot = str(identity.get("ROBOT", ""))
    if not robot:
        return LawSentence("laws.arm_missing", "expected an arm behind the device, found another device")
    return LawSentence("laws.arm_other", "expected an arm behind the device, found {other}", other=robot)
