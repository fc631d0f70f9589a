"""The middle of all that has one colour, however bright it is."""

import numpy as np
import numpy.typing as npt

Pixels = npt.NDArray[np.uint8]

_ALIKE = 0.85
"""Cosine of how far a colour may be from the one that is looked for, seen from grey."""
_GREY = 1e-6


class ColourBlob:
    """Finds what has the colour `rgb` (three numbers, of any scale); grey itself is no colour: ValueError.

    `least` is how far from grey it has to be, of 255. Differences of brightness do not count: two lamps make a shape
    brighter, and hardly change how far its colour leans.
    """

    def __init__(self, rgb: npt.ArrayLike, least: float) -> None:
        colour = np.array(rgb, dtype=np.float32).reshape(3)
        lean = colour - colour.mean()
        length = float(np.linalg.norm(lean))
        if not np.isfinite(length) or length < _GREY * max(1.0, float(np.abs(colour).max())):
            raise ValueError(f"expected a colour, found {colour.tolist()}")
        self._lean = lean / np.float32(length)
        self._least = np.float32(least)

    def middle(self, pixels: Pixels) -> tuple[float, float, int]:
        """u to the right and v down from the middle of the first pixel, and how many pixels have the colour."""
        seen = pixels.astype(np.float32)
        along = seen @ self._lean
        total = seen.sum(axis=2)
        away = np.einsum("ijk,ijk->ij", seen, seen) - total * total / np.float32(3.0)
        has_colour = (along > self._least) & (along * along > np.float32(_ALIKE**2) * away)
        columns, rows = has_colour.sum(axis=0), has_colour.sum(axis=1)
        count = int(rows.sum())
        if not count:
            return 0.0, 0.0, 0
        return float(columns @ np.arange(columns.size)) / count, float(rows @ np.arange(rows.size)) / count, count
