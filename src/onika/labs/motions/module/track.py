"""A target that moves."""

import numpy as np

from onika.laws.frames import rotation_exp, rotation_log
from onika.laws.path import PEAK, quintic
from onika.module import Input, InVar, Local, Module, ModuleError, OutVar, finish

NEAR = 0.005  # m


class Track(Module):
    """Brings the tool to a pose that moves, and stays with it for a while.

    Its share of the way to the pose grows from 0 to 1 as the fifth-order law does, so that it begins at rest; from then
    on it is where the pose is, beside it by OFFSET.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR   X_PART  double[4,4]  -      the pose that moves, in the world
             INVAR   X_MEZ   double[4,4]  -      measured pose; the start where no reference is in force
             OUTVAR  X_REF   double[4,4]  -      reference pose; preloaded at `on`, it is the start
    Local    OFFSET          double[3]    m      where the tool is beside the pose, along the axes of the world
             SPEED           double       m/s    about the peak speed at which it comes nearer
             TURN            double       rad/s  about the peak speed of its turning
             MOST            double       m/s    how fast the pose may move
    Input    duration        double       s      0..86400
    Finish   flow 1, loop FALSE, when it has been with it for duration; flow 0 where the tool is not within 5 mm then
    Errors   too fast  the pose moves faster than MOST: ERROR, the arm stays where it is
    Get/Set  away, in m, from tool to pose / -
    Source   dissertation §4.4
    """

    trigger = True

    X_PART = InVar("double[4,4]", "-", "the pose that moves, in the world")
    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    OFFSET = Local(
        "double[3]", "m", "where the tool is beside the pose, along the axes of the world", default=(0.0, 0.0, 0.0)
    )
    SPEED = Local("double", "m/s", "about the peak speed at which it comes nearer", default=0.2, low=1e-3)
    TURN = Local("double", "rad/s", "about the peak speed of its turning", default=1.0, low=1e-3)
    MOST = Local("double", "m/s", "how fast the pose may move", default=0.5, low=1e-3)

    duration = Input("double", "s", "how long it stays with it", low=0.0, high=86_400.0)

    def on(self, inputs):
        start = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()
        self._last = self.X_PART[:3, 3].copy()
        self._start = start
        way, turn = float(np.linalg.norm(self._goal() - start[:3, 3])), float(np.linalg.norm(self._turn()))
        self._lead = PEAK * max(way / self.SPEED, turn / self.TURN)
        self._time, self._whole = 0.5 * self.dt, self._lead + inputs.duration  # half a period decides safely
        self.X_REF = start

    def cycle(self):
        self._check_speed()
        self._time += self.dt
        share, _ = quintic(self._time, self._lead)
        self.X_REF = self.X_PART
        self.X_REF[:3, 3] = self._goal()
        if share < 1.0:
            self.X_REF[:3, 3] = self._start[:3, 3] + share * (self._goal() - self._start[:3, 3])
            self.X_REF[:3, :3] = self._start[:3, :3] @ rotation_exp(share * self._turn())
        if self._time < self._whole:
            return None
        return finish(flow=int(self._distance() <= NEAR))

    def get(self, name):
        return self._distance() if name == "away" else super().get(name)

    def _goal(self):
        return self.X_PART[:3, 3] + self.OFFSET

    def _turn(self):
        """The turn from how the tool pointed at first to how the pose does."""
        return rotation_log(self._start[:3, :3].T @ self.X_PART[:3, :3])

    def _distance(self):
        return float(np.linalg.norm(self.X_MEZ[:3, 3] - self._goal()))

    def _check_speed(self):
        speed = float(np.linalg.norm(self.X_PART[:3, 3] - self._last)) / self.dt
        self._last = self.X_PART[:3, 3].copy()
        if speed > self.MOST:
            raise ModuleError(
                "what is tracked moves at {speed:.2f} m/s, and may move at {most:g} m/s", speed=speed, most=self.MOST
            )
