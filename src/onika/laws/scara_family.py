"""Whether four screws are those of the SCARA family, and the table that its closed form of the inverse reads.

Axes 1 and 2 are parallel and point alike, joint 3 slides along them, axis 4 points as joint 3 slides.
"""

import math

import numpy as np

from onika.laws.chain import SLIDES
from onika.laws.family_table import EXACT, FamilyTable, across, frame, turn_about
from onika.laws.frames import Array
from onika.laws.screws import places, slides


def scara_table(screw: Array) -> FamilyTable | None:
    """The table behind SCREW double[4,6]; None where it is of another family."""
    if screw.shape != (4, 6) or slides(screw).tolist() != [False, False, True, False]:
        return None
    up, quill, p = screw[0, :3], screw[2, 3:], places(screw)
    down = math.copysign(1.0, float(up @ quill))
    apart = (screw[1, :3] - up, quill - down * up, screw[3, :3] - quill)
    if max(float(np.linalg.norm(difference)) for difference in apart) > EXACT:
        return None
    inner, outer = across(up, p[1] - p[0]), across(up, p[3] - p[1])
    a1, a2 = float(np.linalg.norm(inner)), float(np.linalg.norm(outer))
    if min(a1, a2) <= EXACT:
        return None
    x1, x2 = inner / a1, outer / a2
    bend = math.pi if down < 0.0 else 0.0
    dh = np.array(
        [[a1, 0.0, 0.0, 0.0], [a2, bend, 0.0, turn_about(up, x1, x2)], [0.0, 0.0, 0.0, SLIDES], [0.0, 0.0, 0.0, 0.0]]
    )
    return FamilyTable(dh, frame(x1, up, p[0]), frame(x2, quill, p[0] + inner + outer))
