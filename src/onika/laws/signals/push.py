"""How fast a push is meant: nothing near the middle, then finely, at the end all of it."""

import numpy as np

from onika.laws.frames import Array, Numbers


def strength(push: Numbers, zone: float, curve: float) -> Array:
    """Of a push double[3], -1..1 each, where it leads and how much, no longer than 1; what is no number is let go.

    zone    how far from the middle counts as let go, 0..1
    curve   share of the third power, 0..1: the more, the finer near the middle

    It points where the push does, so that a small push goes straight, too.
    """
    axes = np.asarray(push, dtype=np.float64)
    wanted = np.where(np.isfinite(axes), axes, 0.0)
    length = float(np.linalg.norm(wanted))
    if length <= zone or length == 0.0:
        return np.zeros(3)
    share = min((length - zone) / (1.0 - zone), 1.0)
    amount = (1.0 - curve) * share + curve * share**3
    return np.asarray(wanted * (amount / length))
