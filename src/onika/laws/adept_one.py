"""An Adept One-like SCARA as constants: two turning joints, a quill that slides down, its roll; named as variables are.

Frame 0 stands where the PUMA's shoulder would, the arm's plane 0.30 m above it; joint 3 counts downwards. Links of
0.425 and 0.375 m and the long stroke of 0.295 m are the Adept One's; masses, inertias, friction and limits of speed and
torque are plausible, not measured. The hand is the PUMA's. DH and angles as in `onika.laws.puma560`, DH with a full
turn in the row of the joint that slides.
"""

import math

import numpy as np

from onika.laws import puma560
from onika.laws.chain import SLIDES
from onika.laws.frames import Array

ROBOT = "adept_one"
NDOF = 4


def _frozen(rows: list[list[float]] | list[float]) -> Array:
    array = np.array(rows, dtype=np.float64)
    array.flags.writeable = False
    return array


# a (m), alpha (rad), d (m), theta offset (rad)
DH = _frozen([[0.425, 0.0, 0.30, 0.0], [0.375, math.pi, 0.0, 0.0], [0.0, 0.0, 0.24, SLIDES], [0.0, 0.0, 0.0, 0.0]])

# mass (kg), centre of mass x y z (m, frame i), Ixx Iyy Izz (kg m2, about it), armature and viscous friction of the
# joint: kg m2 and N m s/rad where it turns, kg and N s/m where it slides
DYN = _frozen(
    [
        [15.0, -0.21, 0.0, 0.0, 0.05, 0.25, 0.25, 2.0, 6.0],
        [10.0, -0.19, 0.0, 0.0, 0.03, 0.14, 0.14, 1.0, 3.0],
        [3.0, 0.0, 0.0, -0.20, 0.06, 0.06, 0.002, 8.0, 40.0],
        [0.5, 0.0, 0.0, -0.02, 6e-4, 6e-4, 4e-4, 0.05, 0.2],
    ]
)

LOAD = puma560.LOAD

QMIN = _frozen([math.radians(-150), math.radians(-147), 0.0, math.radians(-270)])
QMAX = _frozen([math.radians(150), math.radians(147), 0.295, math.radians(270)])
QDMAX = _frozen([math.radians(150), math.radians(200), 0.6, math.radians(360)])
TAUMAX = _frozen([300.0, 150.0, 600.0, 20.0])

# gains of the joint servo: N m/rad and N m s/rad; N/m and N s/m of joint 3
KP = _frozen([6000.0, 4000.0, 40000.0, 300.0])
KD = _frozen([400.0, 200.0, 1400.0, 15.0])

TOOL = puma560.TOOL

# folded to the right of the table, quill up, fingers as the boxes want them
HOME = _frozen([math.radians(-100), math.radians(120), 0.0, math.radians(-70)])
