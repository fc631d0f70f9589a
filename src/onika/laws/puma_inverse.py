"""Closed-form inverse kinematics of the PUMA family: shoulder offset, two long links, spherical wrist.

The family's standard Denavit-Hartenberg table has alpha = (-90, 0, 90, -90, 90, 0) degrees, a = (0, a2, a3, 0, 0, 0)
and d = (d1, d2, d3, d4, 0, d6), theta offsets as they like; `onika.laws.puma_family` finds it behind screws. Eight
branches: shoulder, elbow, wrist (Fu, Gonzalez & Lee, Robotics, §2.3.2, solved here by the wrist's distance). Singular
cases: the wrist on the axis of joint 1's offset cylinder and the stretched arm merge two branches; with axes 4 and 6 in
line, joint 4 stays where it was.
"""

import math
from collections.abc import Iterator

import numpy as np

from onika.laws.frames import Array, Numbers, inverse_pose
from onika.laws.sentence import LawSentence, joint_beyond

_TURN = 2.0 * math.pi
_ROUNDING = 1e-9  # m, rad and shares: how far beyond a border still counts as on it
_IN_LINE = 1e-8  # sine of joint 5 below which axes 4 and 6 are one

_Flat = tuple[float, ...]


class PumaInverse:
    """The inverse of one arm of the family, with its base, tool and limits (double[6], rad)."""

    def __init__(self, dh: Array, base: Array, tool: Array, qmin: Array, qmax: Array) -> None:
        a, d = dh[:, 0].tolist(), dh[:, 2].tolist()
        self._d1, self._side, self._d6 = d[0], d[1] + d[2], d[5]
        self._upper, self._lower, self._bend0 = a[1], math.hypot(a[2], d[3]), math.atan2(d[3], a[2])
        self._offset: list[float] = dh[:, 3].tolist()
        self._low, self._high = [float(x) for x in qmin], [float(x) for x in qmax]
        self._from_base = None if np.array_equal(base, np.eye(4)) else _flat(inverse_pose(base))
        unturned = np.array_equal(tool[:3, :3], np.eye(3))
        self._to_flange = None if unturned else _flat(inverse_pose(tool))
        self._tool = tool[:3, 3].tolist()

    def nearest(self, pose: Array, q_near: Numbers) -> Array | LawSentence:
        """The solution double[6] within limits nearest to `q_near`, or the reason why there is none."""
        near = q_near.tolist() if isinstance(q_near, np.ndarray) else [float(x) for x in q_near]
        flange = self._flange(pose)
        arms = self._arm_branches(flange)
        if isinstance(arms, str):
            return arms
        best, solution = math.inf, None
        for bound, arm in sorted((_turned_distance(arm, near), arm) for arm in arms):
            if bound >= best:
                break  # limits only lead further away
            placed = self._placed(arm, near, 0)
            if placed is None:
                continue
            cost = _distance(placed, near, 0)
            for wrist in self._wrist_branches(flange, arm, near):
                turned = self._placed(wrist, near, 3)
                if turned is not None and cost + _distance(turned, near, 3) < best:
                    best, solution = cost + _distance(turned, near, 3), placed + turned
        if solution is None:
            return self._why(flange, near)
        return np.array(solution)

    def branches(self, pose: Array, q_near: Numbers) -> list[Array]:
        """All solutions, limits or not, each joint as near to `q_near` as whole turns allow; empty out of reach."""
        near = [float(x) for x in q_near]
        return [
            np.array([q + _TURN * round((n - q) / _TURN) for q, n in zip(branch, near, strict=True)])
            for branch in self._all_branches(self._flange(pose), near)
        ]

    def _flange(self, pose: Array) -> _Flat:
        """Rotation (n, o, a columns by rows) and position of frame 6 in frame 0, twelve numbers by rows."""
        x = _flat(pose)
        if self._from_base is not None:
            x = _product(self._from_base, x)
        if self._to_flange is not None:
            return _product(x, self._to_flange)
        tx, ty, tz = self._tool
        return (
            *(x[0], x[1], x[2], x[3] - x[0] * tx - x[1] * ty - x[2] * tz),
            *(x[4], x[5], x[6], x[7] - x[4] * tx - x[5] * ty - x[6] * tz),
            *(x[8], x[9], x[10], x[11] - x[8] * tx - x[9] * ty - x[10] * tz),
        )

    def _arm_branches(self, x: _Flat) -> list[list[float]] | LawSentence:
        """The four (q1, q2, q3) that bring the wrist to its place, or why there is none."""
        wx, wy, wz = x[3] - self._d6 * x[2], x[7] - self._d6 * x[6], x[11] - self._d6 * x[10]
        side, upper, lower = self._side, self._upper, self._lower
        square = wx * wx + wy * wy - side * side
        if not square >= -_ROUNDING:
            radius = math.hypot(wx, wy)
            return LawSentence(
                "laws.wrist_near",
                "out of reach: the wrist would be {radius:.3f} m from joint 1's axis, nearest is {nearest:.3f} m",
                radius=radius,
                nearest=abs(side),
            )
        forward, down = math.sqrt(max(square, 0.0)), self._d1 - wz
        along = (forward * forward + down * down - upper * upper - lower * lower) / (2.0 * upper)
        if not abs(along) <= lower * (1.0 + _ROUNDING):
            return LawSentence(
                "laws.wrist_far",
                "out of reach: the wrist would be {distance:.3f} m from the shoulder, "
                "possible are {low:.3f}..{high:.3f} m",
                distance=math.hypot(forward, down),
                low=abs(upper - lower),
                high=upper + lower,
            )
        bend = math.acos(max(-1.0, min(1.0, along / lower)))
        lean = math.atan2(lower * math.sin(bend), upper + along)
        about = math.atan2(wy, wx)
        o1, o2, o3 = self._offset[0], self._offset[1], self._offset[2]
        result = []
        for reach in (forward, -forward):
            q1, rise = about - math.atan2(side, reach) - o1, math.atan2(down, reach) - o2
            result.append([q1, rise - lean, self._bend0 + bend - o3])
            result.append([q1, rise + lean, self._bend0 - bend - o3])
        return result

    def _wrist_branches(self, x: _Flat, arm: list[float], near: list[float]) -> list[list[float]]:
        """The two (q4, q5, q6) that turn the hand, given the arm's three joints."""
        o1, o2, o3, o4, o5, o6 = self._offset
        q1, q23 = arm[0] + o1, arm[1] + o2 + arm[2] + o3
        c1, s1, c, s = math.cos(q1), math.sin(q1), math.cos(q23), math.sin(q23)
        # the hand's approach in frame 3 is (c4 s5, s4 s5, c5)
        flat = c1 * x[2] + s1 * x[6]
        ax, ay, az = c * flat - s * x[10], c1 * x[6] - s1 * x[2], s * flat + c * x[10]
        sine = math.sqrt(ax * ax + ay * ay)
        if sine < _IN_LINE:
            q4 = near[3] + o4
            turn = math.atan2(c1 * x[4] - s1 * x[0], c * (c1 * x[0] + s1 * x[4]) - s * x[8])
            if az > 0.0:
                return [[q4 - o4, -o5, turn - q4 - o6]]
            return [[q4 - o4, math.pi - o5, q4 - turn - math.pi - o6]]
        q4, q5 = math.atan2(ay, ax), math.atan2(sine, az)
        nz, oz = s * (c1 * x[0] + s1 * x[4]) + c * x[8], s * (c1 * x[1] + s1 * x[5]) + c * x[9]
        q6 = math.atan2(oz, -nz)
        return [[q4 - o4, q5 - o5, q6 - o6], [q4 + math.pi - o4, -q5 - o5, q6 + math.pi - o6]]

    def _placed(self, joints: list[float], near: list[float], first: int) -> list[float] | None:
        """Three joints turned by whole turns to within limits, as near to `near` as that allows; None if none fits."""
        placed = []
        low, high = self._low, self._high
        for k, q in enumerate(joints, first):
            if low[k] <= q <= high[k] and -math.pi < q - near[k] < math.pi:
                placed.append(q)  # as mostly: within limits and less than half a turn away
                continue
            turned = q + _TURN * round((near[k] - q) / _TURN)
            if turned < low[k] - _ROUNDING:
                turned += _TURN * math.ceil((low[k] - _ROUNDING - turned) / _TURN)
            elif turned > high[k] + _ROUNDING:
                turned -= _TURN * math.ceil((turned - high[k] - _ROUNDING) / _TURN)
            if not low[k] - _ROUNDING <= turned <= high[k] + _ROUNDING:
                return None
            placed.append(min(max(turned, low[k]), high[k]))
        return placed

    def _all_branches(self, flange: _Flat, near: list[float]) -> Iterator[list[float]]:
        arms = self._arm_branches(flange)
        if not isinstance(arms, str):
            for arm in arms:
                for wrist in self._wrist_branches(flange, arm, near):
                    yield arm + wrist

    def _why(self, flange: _Flat, near: list[float]) -> LawSentence:
        """Which joint stops the branch that comes nearest to being possible."""
        worst = (max(self._excess(k, q) for k, q in enumerate(branch)) for branch in self._all_branches(flange, near))
        _, k, q = min(worst, key=lambda excess: excess[0])
        return joint_beyond(k + 1, q, "rad", self._low[k], self._high[k])

    def _excess(self, k: int, q: float) -> tuple[float, int, float]:
        middle = 0.5 * (self._low[k] + self._high[k])
        turned = q + _TURN * round((middle - q) / _TURN)
        return max(self._low[k] - turned, turned - self._high[k]), k, turned


def _flat(pose: Array) -> _Flat:
    return tuple(pose.ravel().tolist()[:12])


def _product(a: _Flat, b: _Flat) -> _Flat:
    """Two poses of twelve numbers by rows, multiplied."""
    a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11 = a
    b0, b1, b2, b3, b4, b5, b6, b7, b8, b9, b10, b11 = b
    return (
        *(a0 * b0 + a1 * b4 + a2 * b8, a0 * b1 + a1 * b5 + a2 * b9),
        *(a0 * b2 + a1 * b6 + a2 * b10, a0 * b3 + a1 * b7 + a2 * b11 + a3),
        *(a4 * b0 + a5 * b4 + a6 * b8, a4 * b1 + a5 * b5 + a6 * b9),
        *(a4 * b2 + a5 * b6 + a6 * b10, a4 * b3 + a5 * b7 + a6 * b11 + a7),
        *(a8 * b0 + a9 * b4 + a10 * b8, a8 * b1 + a9 * b5 + a10 * b9),
        *(a8 * b2 + a9 * b6 + a10 * b10, a8 * b3 + a9 * b7 + a10 * b11 + a11),
    )


def _turned_distance(arm: list[float], near: list[float]) -> float:
    """Squared distance of three joints to `near`, by whole turns as near as can be."""
    first, two, three = arm[0] - near[0], arm[1] - near[1], arm[2] - near[2]
    first -= _TURN * round(first / _TURN)
    two -= _TURN * round(two / _TURN)
    three -= _TURN * round(three / _TURN)
    return first * first + two * two + three * three


def _distance(joints: list[float], near: list[float], first: int) -> float:
    a, b, c = joints[0] - near[first], joints[1] - near[first + 1], joints[2] - near[first + 2]
    return a * a + b * b + c * c
