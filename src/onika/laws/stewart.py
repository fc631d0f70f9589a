"""A platform on six legs (Gough 1956, Stewart 1965): lengths of a pose in closed form, the pose of lengths by Newton.

l_k = |p + R h_k - f_k|, f the feet in the base, h the heads in the plate (Merlet, Parallel Robots, §3, §4).
"""

import numpy as np

from onika.laws.frames import Array, Numbers, as_array, rotation_exp
from onika.laws.sentence import LawSentence

_TOLERANCE = 1e-12  # m: the largest leg's error at which Newton is content
_ITERATIONS = 30


class Platform:
    """Six legs from `feet` to `heads`, each double[6,3] (m); frame 0 is the base's, poses are the plate's in it."""

    def __init__(self, feet: Numbers, heads: Numbers) -> None:
        self._feet, self._heads = as_array(feet, (6, 3)), as_array(heads, (6, 3))

    def lengths(self, pose: Array) -> Array:
        """The lengths double[6] (m) of the legs where the plate is at `pose`."""
        lengths: Array = np.linalg.norm(self._legs(pose), axis=1)
        return lengths

    def rates(self, pose: Array) -> Array:
        """The lengths' rates double[6,6] per twist of the plate in frame 0: three columns of m/s, three of rad/s."""
        legs = self._legs(pose)
        along = legs / np.linalg.norm(legs, axis=1)[:, None]
        arms = self._heads @ pose[:3, :3].T
        return np.hstack((along, np.cross(arms, along)))

    def pose(self, lengths: Array, near: Array) -> Array | LawSentence:
        """The pose double[4,4] near another one whose legs have these lengths (m), or why there is none."""
        pose = near.copy()
        for _ in range(_ITERATIONS):
            error = lengths - self.lengths(pose)
            if float(np.abs(error).max()) <= _TOLERANCE:
                return pose
            step = np.linalg.lstsq(self.rates(pose), error, rcond=1e-9)[0].tolist()
            pose[:3, 3] += step[:3]
            pose[:3, :3] = rotation_exp(step[3:]) @ pose[:3, :3]
        return LawSentence(
            "laws.legs_apart",
            "no pose near the last one has these leg lengths: the nearest is {metres:.6f} m off",
            metres=float(np.abs(lengths - self.lengths(pose)).max()),
        )

    def _legs(self, pose: Array) -> Array:
        """From each foot to its head double[6,3]."""
        return pose[:3, 3] + self._heads @ pose[:3, :3].T - self._feet
