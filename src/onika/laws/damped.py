"""Inverse kinematics of any arm by damped least squares within joint limits.

dq = (J^T J + lambda^2 I)^-1 J^T e, e = (p* - p, log(R* R^T)) (Wampler 1986; Nakamura & Hanafusa 1986), lambda as
large as the error. A joint that stands at a limit and would be pushed beyond it is left out of a step. An arm with
fewer than six joints reaches the poses that its joints allow, and no others; one with more keeps its posture: of all
steps the shortest is taken. A pose that is written in a few digits lies a little beside what such an arm reaches: what
cannot be had more exactly is taken as it is where it is hardly off.
"""

import math

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.frames import Array, Numbers, rotation_log
from onika.laws.sentence import LawSentence

_TOLERANCE = 1e-8  # m and rad together
_GRAIN = 1e-4  # m and rad together: what is so near, and comes no nearer, is where a pose of four digits is meant
_LEAST_DAMPING = (
    1e-6  # no joint flies away for a hair: directions in which the tool moves by less than 1e-3 hardly count
)
_ITERATIONS = 60
_LITTLE_LESS = 0.9  # of the error before a step: what is left cannot be had
_LOOK, _LESS = 10, 0.7  # after so many steps the error has to be less than this share, else a way leads nowhere
STARTS = 60
"""From how many other postures a solution is looked for where the way from the near one leads nowhere."""
_ENOUGH = 4  # solutions from other postures, of which the nearest is taken
_AT_LIMIT = 0.01  # rad or m: a joint so near to its limit cannot go on
_LONGEST_STEP = 0.5  # rad or m
_WIDE = 1e3  # rad or m: a limit beyond it is none
_FREE = {False: math.pi, True: 1.0}  # rad, m: between which postures a joint without limits is started, either way


class DampedInverse:
    """The inverse of one arm within limits double[n]; `starts` 0: what is not near is out of reach."""

    def __init__(self, arm: ArmModel, qmin: Array, qmax: Array, starts: int = STARTS) -> None:
        self._arm = arm
        self._low, self._high = qmin, qmax
        free = np.array([_FREE[bool(slide)] for slide in arm.slides])
        low, high = np.where(qmin < -_WIDE, -free, qmin), np.where(qmax > _WIDE, free, qmax)
        # the same starts every time: equal questions have equal answers
        share = np.random.default_rng(1).uniform(0.1, 0.9, (starts, arm.n))
        share[:1] = 0.5
        self._starts = low + share * (high - low)
        self._pose, self._jacobian = np.eye(4), np.empty((6, arm.n))

    def nearest(self, pose: Array, q_near: Numbers) -> Array | LawSentence:
        """A solution within limits, from `q_near` if the way leads there, else the nearest one found; or the reason."""
        near = np.clip(np.asarray(q_near, dtype=np.float64), self._low, self._high)
        if not np.isfinite(pose).all():
            return LawSentence("laws.pose_infinite", "the pose is not finite")
        if not len(self._starts):
            q, error = self._descend(pose, near, is_gentle=True)
            return q if _size(error) <= _GRAIN else self._why_not(near, error)
        tried = [self._descend(pose, near)]
        if _size(tried[0][1]) <= _TOLERANCE:
            return tried[0][0]
        solved = []
        for start in self._starts:
            tried.append(self._descend(pose, start))
            if _size(tried[-1][1]) <= _TOLERANCE:
                solved.append(tried[-1][0])
            if len(solved) == _ENOUGH:
                break
        if solved:
            return min(solved, key=lambda q: float((q - near) @ (q - near)))
        gentle = self._descend(pose, near, is_gentle=True)
        q, error = gentle if _size(gentle[1]) <= _GRAIN else min(tried, key=lambda each: _size(each[1]))
        return q if _size(error) <= _GRAIN else self._why_not(near, error)

    def _why_not(self, near: Array, error: Array) -> LawSentence:
        """Why a pose is out of reach; who looks only near the last posture is told what ends the way from there."""
        if len(self._starts):
            metres, radians = float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:]))
            return LawSentence(
                "laws.posture_away",
                "out of reach: the nearest posture found within limits is {metres:.4f} m and {radians:.4f} rad away",
                metres=metres,
                radians=radians,
            )
        spare = np.minimum(near - self._low, self._high - near)
        joint = int(spare.argmin())
        if spare[joint] < _AT_LIMIT:
            return LawSentence(
                "laws.way_ends_at_limit",
                "the way leads out of reach: joint {joint} stands at its limit",
                joint=joint + 1,
            )
        return LawSentence("laws.way_ends", "the way leads out of reach: no posture beside the last one is on it")

    def _descend(self, pose: Array, start: Array, *, is_gentle: bool = False) -> tuple[Array, Array]:
        """Where the way from there ends, and what is left; gently it goes no further for what hardly counts."""
        least = _LEAST_DAMPING if is_gentle else 1e-14
        q = start.copy()
        error = self._error(pose, q)
        before = last = math.inf
        for count in range(_ITERATIONS):
            size = _size(error)
            if size <= _TOLERANCE or (is_gentle and _GRAIN >= size > _LITTLE_LESS * last):
                break
            last = size
            if count % _LOOK == 0:
                if size > _LESS * before:
                    break
                before = size
            step = self._step(q, error, min(size * size, 1e-2) + least)
            step *= min(1.0, _LONGEST_STEP / max(float(np.abs(step).max()), 1e-12))
            q = np.clip(q + step, self._low, self._high)
            error = self._error(pose, q)
        return q, error

    def _step(self, q: Array, error: Array, damping: float) -> Array:
        """The damped step of the joints that no limit stops."""
        jacobian = self._arm.jacobian(q, self._jacobian)
        downhill = jacobian.T @ error
        free = ((q > self._low) | (downhill > 0.0)) & ((q < self._high) | (downhill < 0.0))
        step = np.zeros(self._arm.n)
        columns = jacobian[:, free]
        normal = columns.T @ columns
        normal.flat[:: columns.shape[1] + 1] += damping
        step[free] = np.linalg.solve(normal, downhill[free])
        return step

    def _error(self, pose: Array, q: Array) -> Array:
        here = self._arm.forward(q, self._pose)
        return np.concatenate((pose[:3, 3] - here[:3, 3], rotation_log(pose[:3, :3] @ here[:3, :3].T)))


def _size(error: Array) -> float:
    return float(np.sqrt(error @ error))
