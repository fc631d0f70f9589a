"""A point of a picture, found again in the next one by what is around it."""

import numpy as np
import numpy.typing as npt

Pixels = npt.NDArray[np.uint8]
Grey = npt.NDArray[np.float32]

_HALF = 10  # px from the point to the edge of what is compared
_STRIDE = 2  # of the first, coarse comparison
_PLAIN = 4.0  # grey levels: where all is as alike as that there is nothing to find again
_UNLIKE = 30.0  # grey levels by which what is found may differ


class PicturePatch:
    """What is around the point (u, v) of a picture; raises ValueError where all is alike there, or beyond its edge.

    `reach` is how far, in pixels, the point may have moved from one picture to the next.
    """

    def __init__(self, pixels: Pixels, u: float, v: float, reach: int = 40) -> None:
        grey = _grey(pixels)
        height, width = grey.shape
        if not (0 <= u <= width - 1 and 0 <= v <= height - 1):
            raise ValueError(f"expected a point within {width} x {height}, found {u:g} {v:g}")
        column, row = self._inside(grey, round(u), round(v))
        self._beside = u - column, v - row
        self._at = column, row
        self._patch = grey[row - _HALF : row + _HALF + 1, column - _HALF : column + _HALF + 1].copy()
        if float(self._patch.std()) < _PLAIN:
            raise ValueError("expected something around the point, found that all is alike there")
        self._reach = reach

    @property
    def at(self) -> tuple[float, float]:
        """Where the point was last."""
        return self._at[0] + self._beside[0], self._at[1] + self._beside[1]

    def find(self, pixels: Pixels) -> bool:
        """Look for it near where it was last; False: it is not there."""
        grey = _grey(pixels)
        column, row = self._inside(grey, *self._at)
        coarse, _ = self._best(grey, (column, row), self._reach, _STRIDE)
        place, off = self._best(grey, coarse, _STRIDE, 1)
        if off > _UNLIKE:
            return False
        self._at = place
        return True

    def _best(self, grey: Grey, around: tuple[int, int], reach: int, stride: int) -> tuple[tuple[int, int], float]:
        """The place where it fits best within `reach`, and by how many grey levels it differs there."""
        patch = self._patch[::stride, ::stride]
        height, width = grey.shape
        columns = _steps(around[0], reach, stride, width)
        rows = _steps(around[1], reach, stride, height)
        down = slice(rows[0] - _HALF, rows[-1] + _HALF + 1, stride)
        part = grey[down, columns[0] - _HALF : columns[-1] + _HALF + 1 : stride]
        seen = np.lib.stride_tricks.sliding_window_view(part, patch.shape)
        difference = seen - seen.mean(axis=(2, 3), keepdims=True) - (patch - patch.mean())
        squares = np.einsum("ijkl,ijkl->ij", difference, difference)
        best = int(squares.argmin())
        row, column = divmod(best, squares.shape[1])
        off = float(np.sqrt(squares.flat[best] / patch.size))
        return (columns[0] + stride * column, rows[0] + stride * row), off

    @staticmethod
    def _inside(grey: Grey, column: int, row: int) -> tuple[int, int]:
        """The nearest place around which a patch lies in the picture; raises ValueError for a picture too small."""
        height, width = grey.shape
        if min(height, width) < 2 * _HALF + 1:
            raise ValueError(f"expected a picture of at least {2 * _HALF + 1} pixels, found {width} x {height}")
        return min(max(column, _HALF), width - 1 - _HALF), min(max(row, _HALF), height - 1 - _HALF)


def _steps(middle: int, reach: int, stride: int, size: int) -> range:
    """Places along one side, with `middle` in their grid, whose patches lie in the picture."""
    below = min(reach, middle - _HALF) // stride
    above = min(reach, size - 1 - _HALF - middle) // stride
    return range(middle - below * stride, middle + above * stride + 1, stride)


def _grey(pixels: Pixels) -> Grey:
    grey: Grey = pixels.mean(axis=2, dtype=np.float32)
    return grey
