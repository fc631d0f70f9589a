"""Inverse kinematics of any serial arm by damped least squares within joint limits.

dq = (J^T J + lambda^2 I)^-1 J^T e, e = (p* - p, log(R* R^T)) (Wampler 1986; Nakamura & Hanafusa 1986), lambda as
large as the error. An arm with fewer than six joints reaches the poses that its joints allow, and no others.
"""

import numpy as np

from onika.laws.arm import SerialArm
from onika.laws.frames import Array, Numbers, rotation_log
from onika.laws.sentence import LawSentence

_TOLERANCE = 1e-8  # m and rad together
_ITERATIONS = 60
_STARTS = 12
_LONGEST_STEP = 0.5  # rad or m


class DampedInverse:
    """The inverse of one arm, with its base, tool, limits (double[n]) and kinds of joints."""

    def __init__(self, dh: Array, base: Array, tool: Array, qmin: Array, qmax: Array, kind: Array) -> None:
        self._arm = SerialArm(dh, base=base, tool=tool, kind=kind)
        self._low, self._high = qmin, qmax
        # the same starts every time: equal questions have equal answers
        share = np.random.default_rng(1).uniform(0.15, 0.85, (_STARTS, self._arm.n))
        share[0] = 0.5
        self._starts = qmin + share * (qmax - qmin)
        self._pose, self._jacobian = np.eye(4), np.empty((6, self._arm.n))

    def nearest(self, pose: Array, q_near: Numbers) -> Array | LawSentence:
        """A solution within limits, from `q_near` if the way leads there, else the nearest one found; or the reason."""
        near = np.clip(np.asarray(q_near, dtype=np.float64), self._low, self._high)
        if not np.isfinite(pose).all():
            return LawSentence("laws.pose_infinite", "the pose is not finite")
        q, error = self._descend(pose, near)
        if _size(error) <= _TOLERANCE:
            return q
        solutions = [(q, error), *(self._descend(pose, start) for start in self._starts)]
        solved = [q for q, error in solutions if _size(error) <= _TOLERANCE]
        if solved:
            return min(solved, key=lambda q: float((q - near) @ (q - near)))
        _, error = min(solutions, key=lambda pair: _size(pair[1]))
        metres, radians = float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:]))
        return LawSentence(
            "laws.posture_away",
            "out of reach: the nearest posture found within limits is {metres:.3f} m and {radians:.3f} rad away",
            metres=metres,
            radians=radians,
        )

    def _descend(self, pose: Array, start: Array) -> tuple[Array, Array]:
        q = start.copy()
        error = self._error(pose, q)
        for _ in range(_ITERATIONS):
            size = _size(error)
            if size <= _TOLERANCE:
                break
            jacobian = self._arm.jacobian(q, self._jacobian)
            normal = jacobian.T @ jacobian
            normal.flat[:: self._arm.n + 1] += min(size * size, 1e-2) + 1e-14
            step = np.linalg.solve(normal, jacobian.T @ error)
            step *= min(1.0, _LONGEST_STEP / max(float(np.abs(step).max()), 1e-12))
            q = np.clip(q + step, self._low, self._high)
            error = self._error(pose, q)
        return q, error

    def _error(self, pose: Array, q: Array) -> Array:
        here = self._arm.forward(q, self._pose)
        return np.concatenate((pose[:3, 3] - here[:3, 3], rotation_log(pose[:3, :3] @ here[:3, :3].T)))


def _size(error: Array) -> float:
    return float(np.sqrt(error @ error))
