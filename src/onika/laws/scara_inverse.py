"""Inverse kinematics of the SCARA family in closed form: two parallel turning joints, a quill along them, its roll.

The law of cosines gives joint 2 up to its sign (elbow left or right), height gives joint 3, the yaw joint 4 (Craig,
Introduction to Robotics, §4.4). The hand stays upright; a wanted pose may lean by LEAN and loses that lean. Its table
is found behind screws by `onika.laws.scara_family`.
"""

import math

import numpy as np

from onika.laws.frames import Array, Numbers, inverse_pose
from onika.laws.sentence import LawSentence, joint_beyond

LEAN = 0.05
"""How far a pose may lean from what the arm can do, in rad: 3 degrees, which at the fingers' tips are under 2 mm."""

_TURN = 2.0 * math.pi
_ROUNDING = 1e-9  # m, rad and shares: how far beyond a border still counts as on it
_QUILL = 2  # the joint that slides


class ScaraInverse:
    """The inverse of one arm of the family, with its base, tool and limits (double[4], rad and m)."""

    def __init__(self, dh: Array, base: Array, tool: Array, qmin: Array, qmax: Array) -> None:
        self._inner, self._outer = float(dh[0, 0]), float(dh[1, 0])
        self._down = math.copysign(1.0, math.cos(dh[1, 1]))  # -1: the quill's z points down
        d1, d2, d3, d4 = dh[:, 2].tolist()
        self._level, self._quill = d1 + d2, d3 + d4
        self._offset: list[float] = dh[:, 3].tolist()
        self._low, self._high = qmin.tolist(), qmax.tolist()
        self._from_base = inverse_pose(base)
        self._untool, self._tip = tool[:3, :3].T.copy(), tool[:3, 3].tolist()

    def nearest(self, pose: Array, q_near: Numbers) -> Array | LawSentence:
        """The solution double[4] within limits nearest to `q_near`, or the reason why there is none."""
        solved = self._solved(pose)
        if isinstance(solved, str):
            return solved
        near = [float(x) for x in q_near]
        placed = [self._placed(branch, near) for branch in solved]
        branches = [branch for branch in placed if not isinstance(branch, str)]
        if branches:
            return np.array(min(branches, key=lambda q: math.dist(q, near)))
        # of both elbows the one that is stopped later in the chain tells more
        return max((branch for branch in placed if isinstance(branch, str)), key=lambda why: why.arguments["joint"])

    def _solved(self, pose: Array) -> list[list[float]] | LawSentence:
        """The two elbows' (q1, q2, q3, q4), limits or not, or why there are none."""
        wanted = self._from_base @ pose
        turned = wanted[:3, :3] @ self._untool
        upright = turned[2, 2] * self._down
        if not upright >= math.cos(LEAN):
            lean = math.degrees(math.acos(max(-1.0, min(1.0, upright))))
            return LawSentence(
                "laws.hand_leans",
                "the hand would lean {lean:.0f} degrees; this arm only holds it upright, fingers down",
                lean=lean,
            )
        yaw = math.atan2(turned[1, 0], turned[0, 0])
        cos, sin, (tx, ty, tz) = math.cos(yaw), math.sin(yaw), self._tip
        ty, tz = self._down * ty, self._down * tz
        x, y, z = wanted[0, 3] - cos * tx + sin * ty, wanted[1, 3] - sin * tx - cos * ty, wanted[2, 3] - tz
        inner, outer = self._inner, self._outer
        bend = (x * x + y * y - inner * inner - outer * outer) / (2.0 * inner * outer)
        if not abs(bend) <= 1.0 + _ROUNDING:
            return LawSentence(
                "laws.quill_away",
                "out of reach: the quill would be {distance:.3f} m from joint 1's axis, "
                "possible are {low:.3f}..{high:.3f} m",
                distance=math.hypot(x, y),
                low=abs(inner - outer),
                high=inner + outer,
            )
        q3 = self._down * (z - self._level) - self._quill
        elbow = math.acos(max(-1.0, min(1.0, bend)))
        return [self._branch(x, y, sign, q3, yaw) for sign in (elbow, -elbow)]

    def _branch(self, x: float, y: float, elbow: float, q3: float, yaw: float) -> list[float]:
        o1, o2, o3, o4 = self._offset
        reach, side = self._inner + self._outer * math.cos(elbow), self._outer * math.sin(elbow)
        shoulder = math.atan2(y, x) - math.atan2(side, reach)
        return [shoulder - o1, elbow - o2, q3, self._down * (yaw - shoulder - elbow) - o3 - o4]

    def _placed(self, branch: list[float], near: list[float]) -> list[float] | LawSentence:
        """A branch turned by whole turns to within limits, as near to `near` as that allows; or which joint stops."""
        placed = []
        for k, wanted in enumerate(branch):
            low, high = self._low[k], self._high[k]
            q = wanted if k == _QUILL else _turned(wanted, near[k], low, high)
            if not low - _ROUNDING <= q <= high + _ROUNDING:
                unit = "m" if k == _QUILL else "rad"
                return joint_beyond(k + 1, q, unit, low, high)
            placed.append(min(max(q, low), high))
        return placed


def _turned(q: float, near: float, low: float, high: float) -> float:
    """An angle turned by whole turns towards `near`, and then to within limits where that can be."""
    q += _TURN * round((near - q) / _TURN)
    if q < low - _ROUNDING:
        return q + _TURN * math.ceil((low - _ROUNDING - q) / _TURN)
    if q > high + _ROUNDING:
        return q - _TURN * math.ceil((q - high - _ROUNDING) / _TURN)
    return q
