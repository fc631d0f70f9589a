"""What touch sensors feel in a world without forces: the weight of what stands there, where they are."""

from collections.abc import Collection, Iterator

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.workcell.plant import Plant

_CLOSE_M = 2e-4
"""How near shapes must be to touch."""


class Stillness:
    """The touch sensors of one plant, but for those numbered `others`."""

    def __init__(self, plant: Plant, others: Collection[int]) -> None:
        model = plant.model
        self._model, self._data = model, plant.data
        touch = int(mujoco.mjtSensor.mjSENS_TOUCH)
        sensors = [k for k in range(model.nsensor) if int(model.sensor_type[k]) == touch]
        self._sensors = [k for k in sensors if int(model.sensor_adr[k]) not in others]
        self._sites = {k: int(model.sensor_objid[k]) for k in self._sensors}
        self._felt = np.array([bool(kind) for kind in model.geom_contype | model.geom_conaffinity])
        self._weights = 9.81 * np.ravel(model.body_subtreemass)
        self._bodies: list[int] = model.geom_bodyid.tolist()
        self._reach = np.where(model.geom_rbound > 0.0, model.geom_rbound, np.inf) + _CLOSE_M  # a plane is endless
        self._sizes = np.linalg.norm(model.site_size, axis=1)
        self._seen = b""

    def feel(self) -> None:
        """Write what is felt, if anything has moved since."""
        if not self._sensors:
            return
        seen = self._data.geom_xpos.tobytes()
        if seen == self._seen:
            return
        self._seen = seen
        self._data.sensordata[[int(self._model.sensor_adr[k]) for k in self._sensors]] = 0.0
        for sensor in self._sensors:
            self._data.sensordata[int(self._model.sensor_adr[sensor])] = sum(self._weights_at(self._sites[sensor]))

    def _weights_at(self, site: int) -> Iterator[float]:
        model, ends = self._model, np.zeros(6)
        own = int(model.site_bodyid[site])
        near = self._near(site)
        others = [shape for shape in near if self._bodies[shape] != own]
        for shape in near if others else ():
            if self._bodies[shape] != own:
                continue
            for other in others:
                gap = mujoco.mj_geomDistance(model, self._data, shape, other, 2.0 * _CLOSE_M, ends)
                if gap <= _CLOSE_M and self._is_inside(site, (ends[:3] + ends[3:]) / 2.0):
                    yield float(self._weights[self._bodies[other]])

    def _near(self, site: int) -> list[int]:
        """The shapes that may reach to a site."""
        way = self._data.geom_xpos - self._data.site_xpos[site]
        near = np.einsum("ij,ij->i", way, way) <= (self._reach + self._sizes[site]) ** 2
        shapes: list[int] = np.flatnonzero(near & self._felt).tolist()
        return shapes

    def _is_inside(self, site: int, point: Array) -> bool:
        data, size = self._data, self._model.site_size[site]
        local = np.abs(data.site_xmat[site].reshape(3, 3).T @ (point - data.site_xpos[site]))
        match mujoco.mjtGeom(int(self._model.site_type[site])):
            case mujoco.mjtGeom.mjGEOM_BOX:
                return bool(np.all(local <= size))
            case mujoco.mjtGeom.mjGEOM_CYLINDER:
                return bool(np.hypot(local[0], local[1]) <= size[0] and local[2] <= size[1])
            case mujoco.mjtGeom.mjGEOM_CAPSULE:
                beyond = max(float(local[2]) - float(size[1]), 0.0)
                return bool(np.hypot(np.hypot(local[0], local[1]), beyond) <= size[0])
            case mujoco.mjtGeom.mjGEOM_ELLIPSOID:
                return bool(np.linalg.norm(local / size) <= 1.0)
        return bool(np.linalg.norm(local) <= size[0])
