"""The cameras of a model, as the first draft of a robot's description has them (requirement F05)."""

import re
from collections.abc import Collection
from typing import Any

from onika.model.camera import SIZE, CameraBlock
from onika.words.name import TASK_NAME

MOST = 8
_SMALLEST, _LARGEST = 16, 640


def draft_cameras(model: Any, taken: Collection[str]) -> tuple[CameraBlock, ...]:
    """A block for each camera of a compiled model that has a name of one word, at most eight.

    A camera is called as in the model, where that is a name of a device and none of those that are taken.
    """
    cameras: list[CameraBlock] = []
    names = set(taken)
    for number in range(model.ncam):
        view = str(model.camera(number).name)
        if not view or len(view.split()) != 1 or len(cameras) == MOST:
            continue
        name = _free(view, names)
        names.add(name)
        cameras.append(CameraBlock(name, "" if name == view else view, size=_size(model, number)))
    return tuple(cameras)


def _free(view: str, taken: Collection[str]) -> str:
    """A name of a device that is nobody's."""
    word = re.sub(r"[^A-Za-z0-9_.-]", "_", view)
    word = word if TASK_NAME.match(word) else f"camera_{word}"[:200]
    tries = [word, *(f"{word}_{number}" for number in range(2, 99))]
    return next(name for name in tries if name not in taken)


def _size(model: Any, number: int) -> tuple[int, int]:
    """What the model says of its pictures, where they may be so large."""
    width, height = (int(part) for part in model.cam_resolution[number])
    is_usable = all(_SMALLEST <= part <= _LARGEST for part in (width, height))
    return (width, height) if is_usable else SIZE
