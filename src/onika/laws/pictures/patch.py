"""A point of a picture, found again in the next one by what is around it."""

import numpy as np
import numpy.typing as npt

Pixels = npt.NDArray[np.uint8]
Look = npt.NDArray[np.float32]
Place = tuple[int, int]

_HALF = 10  # px from the point to the edge of what is compared
_STRIDE = 2  # of the first, coarse comparison
_PLAIN = 3.0  # levels, of 255: where all is as alike as that there is nothing to find again
_UNLIKE = 0.7  # share of its own contrast by which what is found may differ
_CHANGED = 0.3  # share of its contrast by which it differs that has come to look otherwise
_DARK = 60.0  # of three times 255: below that colours are not trusted
_GREY = 0.15  # weight of brightness beside colour: a side that turns from the light keeps its colour


class PicturePatch:
    """What is around the point (u, v) of a picture; raises ValueError where all is alike there, or beyond its edge.

    Colours are compared rather than brightness. `reach` is how far, in pixels, the point may have moved from one
    picture to the next.
    """

    def __init__(self, pixels: Pixels, u: float, v: float, reach: int = 30) -> None:
        look = _look(pixels)
        height, width = look.shape[:2]
        if min(height, width) < 2 * _HALF + 1 or not (0 <= u <= width - 1 and 0 <= v <= height - 1):
            raise ValueError(f"expected a point within {width} x {height}, found {u:g} {v:g}")
        column = min(max(round(u), _HALF), width - 1 - _HALF)
        row = min(max(round(v), _HALF), height - 1 - _HALF)
        self._beside = u - column, v - row
        self._at = column, row
        self._reach = reach
        self._take(look)
        if self._contrast < _PLAIN:
            raise ValueError("expected something around the point, found that all is alike there")

    @property
    def at(self) -> tuple[float, float]:
        """Where the point was last."""
        return self._at[0] + self._beside[0], self._at[1] + self._beside[1]

    def find(self, pixels: Pixels) -> bool:
        """Look for it near where it was last; False: it is not there."""
        look = _look(pixels)
        coarse, _ = self._best(look, self._at, self._reach, _STRIDE)
        place, off = self._best(look, coarse, _STRIDE, 1)
        if off > _UNLIKE * self._contrast:
            return False
        self._at = place
        if off > _CHANGED * self._contrast:
            self._take(look)  # seen from elsewhere it looks otherwise
        return True

    def _take(self, look: Look) -> None:
        """Keep what is around the point now."""
        column, row = self._at
        self._patch = look[row - _HALF : row + _HALF + 1, column - _HALF : column + _HALF + 1].copy()
        self._contrast = float(np.sqrt(self._patch.var(axis=(0, 1)).sum()))

    def _best(self, look: Look, around: Place, reach: int, stride: int) -> tuple[Place, float]:
        """The place where it fits best within `reach`, and by how many levels it differs there."""
        patch = self._patch[::stride, ::stride]
        height, width = look.shape[:2]
        columns = _steps(around[0], reach, stride, width)
        rows = _steps(around[1], reach, stride, height)
        down = slice(rows[0] - _HALF, rows[-1] + _HALF + 1, stride)
        part = look[down, columns[0] - _HALF : columns[-1] + _HALF + 1 : stride]
        seen = np.lib.stride_tricks.sliding_window_view(part, patch.shape[:2], axis=(0, 1))
        difference = seen - patch.transpose(2, 0, 1)
        squares = np.einsum("ijklm,ijklm->ij", difference, difference)
        row, column = divmod(int(squares.argmin()), squares.shape[1])
        off = float(np.sqrt(squares[row, column] / (patch.shape[0] * patch.shape[1])))
        return (columns[0] + stride * column, rows[0] + stride * row), off


def _steps(middle: int, reach: int, stride: int, size: int) -> range:
    """Places along one side, with `middle` in their grid, whose patches lie in the picture."""
    below = min(reach, middle - _HALF) // stride
    above = min(reach, size - 1 - _HALF - middle) // stride
    return range(middle - below * stride, middle + above * stride + 1, stride)


def _look(pixels: Pixels) -> Look:
    """Two numbers for how far each pixel leans to red and to blue, one for how bright it is; each about 0 to 255."""
    seen = pixels.astype(np.float32)
    total = seen.sum(axis=2)
    bright = np.float32(255.0) / (total + np.float32(_DARK))
    look: Look = np.stack((seen[:, :, 0] * bright, seen[:, :, 2] * bright, total * np.float32(_GREY / 3.0)), axis=2)
    return look
