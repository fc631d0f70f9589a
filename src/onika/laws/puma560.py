"""The PUMA 560 as constants: kinematics, dynamics, limits, gains and tool, named as state variables are.

Joint angles have the signs of Fu, Gonzalez & Lee (1987), which are those of the dissertation's targets; frame 0 is the
shoulder, 0.6718 m above the floor. Dynamics: Armstrong, Khatib & Burdick (1986) in these frames, except the friction
(Corke) and link 3's Izz, which is raised until the link is a possible rigid body. Limits: Wang & Chen (1991).
"""

import math

import numpy as np

from onika.laws.frames import Array

ROBOT = "puma560"
NDOF = 6


def _frozen(rows: list[list[float]] | list[float]) -> Array:
    array = np.array(rows, dtype=np.float64)
    array.flags.writeable = False
    return array


def _degrees(*angles: float) -> Array:
    return _frozen([math.radians(angle) for angle in angles])


_QUARTER = math.pi / 2

# a (m), alpha (rad), d (m), theta offset (rad)
DH = _frozen(
    [
        [0.0, -_QUARTER, 0.0, 0.0],
        [0.4318, 0.0, 0.14909, 0.0],
        [-0.02032, _QUARTER, 0.0, 0.0],
        [0.0, -_QUARTER, 0.43307, 0.0],
        [0.0, _QUARTER, 0.0, 0.0],
        [0.0, 0.0, 0.05625, 0.0],
    ]
)

# mass (kg), centre of mass x y z (m, frame i), Ixx Iyy Izz (kg m2, about it), armature (kg m2), viscous (N m s/rad)
DYN = _frozen(
    [
        [13.0, 0.0, 0.0, 0.0, 0.35, 0.35, 0.35, 1.14, 5.8],
        [17.40, -0.3638, 0.006, 0.0784, 0.130, 0.524, 0.539, 4.71, 9.5],
        [4.80, 0.0203, 0.014, 0.070, 0.066, 0.086, 0.0201, 0.827, 3.98],
        [0.82, 0.0, 0.019, 0.0, 1.8e-3, 1.3e-3, 1.8e-3, 0.200, 0.41],
        [0.34, 0.0, 0.0, 0.0, 0.3e-3, 0.4e-3, 0.3e-3, 0.179, 0.43],
        [0.09, 0.0, 0.0, -0.0243, 0.15e-3, 0.15e-3, 0.04e-3, 0.193, 0.22],
    ]
)

# the two-finger hand: mass (kg) and its centre (m) in frame 6
LOAD = _frozen([0.78, 0.0, 0.0, 0.075])

QMIN = _degrees(-160, -225, -45, -110, -100, -266)
QMAX = _degrees(160, 45, 225, 170, 100, 266)
QDMAX = _degrees(82, 74, 122, 228, 241, 228)
TAUMAX = _frozen([97.6, 186.4, 89.4, 24.2, 20.1, 21.3])

# gains of the joint servo: N m/rad and N m s/rad, 0.9 of critical damping
KP = _frozen([4000.0, 6000.0, 2500.0, 500.0, 400.0, 300.0])
KD = _frozen([213.0, 382.0, 99.0, 20.0, 18.0, 16.0])

# the point between the fingers, 130 mm beyond the flange
TOOL = _frozen([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.130], [0.0, 0.0, 0.0, 1.0]])

HOME = _frozen([0.0, -_QUARTER, _QUARTER, 0.0, 0.0, 0.0])
