"""What is seen of a runtime between two frames: the newest value under each key, figures and poses."""

from base64 import b64encode
from collections.abc import Mapping
from threading import Lock
from typing import Any

import numpy as np

from onika.desk.environment.reconcile.task_figures import FigureTotals
from onika.desk.environment.reconcile.watches import homes_of, homes_within, keys_of, world_of
from onika.desk.environment.state.model import Model
from onika.wire import live, page, reading

_WORLD = "world:"


class FrameBuffer:
    """Filled in one thread and emptied in another; of two values under one key the newer one is kept."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._tally = FigureTotals()
        self._at_s = 0.0
        self._values: dict[str, Any] = {}
        self._figures: dict[str, dict[str, Any]] = {}
        self._poses: dict[str, Any] = {}
        self._model: Model | None = None
        self._keys: dict[str, tuple[str, ...]] = {}

    def put(self, readings: Mapping[str, bytes], figures: live.Figures | None, model: Model) -> None:
        """What has come."""
        if not readings and figures is None:
            return
        rows = {} if figures is None else self._tally.add(figures, {**homes_of(model), **homes_within(model)})
        if model is not self._model:
            self._model, self._keys = model, {}
        with self._lock:
            self._figures |= rows
            for key, body in readings.items():
                self._read(key, body, model)

    def take(self) -> page.Frame | None:
        """What has come since the last call; None: nothing."""
        with self._lock:
            if not (self._values or self._figures or self._poses):
                return None
            frame = page.Frame(self._at_s, self._values, self._figures, self._poses)
            self._values, self._figures, self._poses = {}, {}, {}
        return frame

    def clear(self) -> None:
        """Forget everything: it was another runtime's."""
        with self._lock:
            self._tally = FigureTotals()
            self._values, self._figures, self._poses = {}, {}, {}

    def _read(self, key: str, body: bytes, model: Model) -> None:
        taken = reading.decode(body)
        if isinstance(taken, reading.Poses):
            self._poses[world_of(model.station, key.removeprefix(_WORLD))] = {
                "rows": _rows(taken.rows),
                "lit": taken.lit,
            }
            return
        if isinstance(taken, reading.CameraPicture):
            file = b64encode(taken.file).decode()
            seen = {"file": file, "number": taken.number, "at_s": taken.at_ns * 1e-9}
            self._poses[world_of(model.station, key.removeprefix(_WORLD))] = seen
            return
        self._at_s = taken.now_ns * 1e-9
        keys = self._keys.get(key)
        if keys is None:
            keys = self._keys[key] = keys_of(model, key)
        for shown in keys:
            self._values[shown] = taken.value


def _rows(rows: bytes) -> list[list[float]]:
    """For each body x y z in m and the quaternion w x y z."""
    poses: list[list[float]] = np.frombuffer(rows, "<f4").reshape(-1, 7).astype(float).round(5).tolist()
    return poses
