"""The inertia of a link, which some descriptions say such that no body can have it (requirement X19)."""

import re
from xml.etree.ElementTree import Element

import numpy as np

_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_KEYS = (("ixx", 0, 0), ("iyy", 1, 1), ("izz", 2, 2), ("ixy", 0, 1), ("ixz", 0, 2), ("iyz", 1, 2))
_LEAST = 1e-9
_SHARE = 1e-6
_ROUND = 1e-9


def possible_inertia(inertia: Element) -> bool:
    """Make an `inertia` such that a body can have it, its axes staying as they are; whether anything was changed.

    Its three moments are positive, and none is larger than the other two together.
    """
    given = np.zeros((3, 3))
    for key, row, column in _KEYS:
        numbers = _NUMBER.findall(inertia.get(key, ""))
        given[row, column] = given[column, row] = float(numbers[0]) if numbers else 0.0
    moments, axes = np.linalg.eigh(given)
    possible = np.maximum(moments, max(_LEAST, _SHARE * float(np.abs(moments).max())))
    lacking = float(possible[2] - possible[0] - possible[1])
    possible = possible + max(lacking, 0.0)
    is_changed = float(np.abs(possible - moments).max()) > _ROUND * float(np.abs(moments).max())
    sound = axes @ np.diag(possible) @ axes.T if is_changed else given
    for key, row, column in _KEYS:
        inertia.set(key, repr(float(sound[row, column])))
    return is_changed
