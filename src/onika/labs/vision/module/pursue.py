"""A base that drives up to what its camera sees."""

import math

import numpy as np

from onika.laws.signals.limited_rate import LimitedRate
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar, finish

STALE = 0.5  # s: an older picture steers nothing


class Pursue(Module):
    """Drives a base up to what its camera sees: it turns towards it, and goes on until it is as low in the picture as
    PLACE says.

    The camera looks forward. On the floor what is nearer is lower in the picture, so that no distance has to be known.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  H       int        -              height of a picture in pixels
             INCONST  W       int        -              width of a picture in pixels
             INCONST  FOCAL   double     -              focal length in pixels
             INVAR    UV      double[2]  -              the point in pixels: to the right, down
             INVAR    AREA    double     -              0: it is not seen
             INVAR    IMG_T   double[2]  -,s            how many pictures there were; how old the newest is
             OUTVAR   V_BASE  double[3]  m/s,m/s,rad/s  wanted speeds: forward, to the left, turning
    Local    PLACE            double[2]  -              where it is to come: shares of width and height
             NEAR             double     -              how near it has to be in pixels
             COUNT            int        -              in how many pictures one after the other
             GAIN             double     m/s            speed for a point that is one focal length too high
             TURNGAIN         double     1/s            share of the turn that it makes in a second
             SPEED            double     m/s            highest speed
             TURN             double     rad/s          highest rate of turning
             RISE             double     m/s^2          how fast the speed may change; turning ten times as much
             WAIT             double     s              how long nothing may be seen
             MOST             double     s              how long it may take
    Finish   flow 0, loop FALSE, when it has been that near in COUNT pictures
    Errors   nothing seen     for WAIT seconds the point was not seen, or no picture came: ERROR, the base stays
             not there        after MOST seconds it has not come to its place: ERROR, the base stays
    Get/Set  away, in pixels, from the place / -
    Source   dissertation §4.5.3
    """

    trigger = True

    H = InConst("int", "-", "height of a picture in pixels")
    W = InConst("int", "-", "width of a picture in pixels")
    FOCAL = InConst("double", "-", "focal length in pixels")
    UV = InVar("double[2]", "-", "the point in pixels: to the right, down")
    AREA = InVar("double", "-", "0: it is not seen")
    IMG_T = InVar("double[2]", "-,s", "how many pictures there were; how old the newest is")
    V_BASE = OutVar("double[3]", "m/s,m/s,rad/s", "wanted speeds: forward, to the left, turning")

    PLACE = Local("double[2]", "-", "where it is to come: shares of width and height", default=(0.5, 0.65))
    NEAR = Local("double", "-", "how near it has to be in pixels", default=2.0, low=0.1)
    COUNT = Local("int", "-", "in how many pictures one after the other", default=3, low=1, high=1000)
    GAIN = Local("double", "m/s", "speed for a point that is one focal length too high", default=2.0, low=0.01)
    TURNGAIN = Local("double", "1/s", "share of the turn that it makes in a second", default=2.0, low=0.01, high=10.0)
    SPEED = Local("double", "m/s", "highest speed", default=0.4, low=1e-3)
    TURN = Local("double", "rad/s", "highest rate of turning", default=1.0, low=1e-3)
    RISE = Local("double", "m/s^2", "how fast the speed may change; turning ten times as much", default=0.6, low=1e-2)
    WAIT = Local("double", "s", "how long nothing may be seen", default=3.0, low=0.1)
    MOST = Local("double", "s", "how long it may take", default=60.0, low=0.1, high=86_400.0)

    def on(self, inputs):
        self._goal = np.array(self.PLACE) * (self.W, self.H) - 0.5
        self._speeds = LimitedRate(np.zeros(2), (self.RISE, 10.0 * self.RISE))
        self._number, self._count, self._unseen, self._time = 0.0, 0, 0.0, 0.0
        self.V_BASE = 0.0

    def cycle(self):
        is_seen = self.AREA > 0 and self.IMG_T[0] > 0 and self.IMG_T[1] < STALE
        if is_seen and self.IMG_T[0] != self._number:
            self._number = self.IMG_T[0]
            self._count = self._count + 1 if self._away() < self.NEAR else 0
        self._watch(is_seen)
        if self._count >= self.COUNT:
            self.V_BASE = 0.0
            return finish()
        self._speeds.follow(self._wanted() if is_seen else np.zeros(2), self.dt)
        self.V_BASE[0], self.V_BASE[2] = self._speeds.value
        return None

    def get(self, name):
        return self._away() if name == "away" else super().get(name)

    def _wanted(self):
        """The speed forward and the rate of turning to the left."""
        right, down = (self.UV - self._goal) / self.FOCAL
        forward = np.clip(-self.GAIN * down, -self.SPEED, self.SPEED)
        turn = np.clip(-self.TURNGAIN * math.atan(right), -self.TURN, self.TURN)
        return np.array((forward, turn))

    def _watch(self, is_seen):
        self._unseen = 0.0 if is_seen or not self.IMG_T[0] else self._unseen + self.dt
        self._time += self.dt
        if self._unseen > self.WAIT:
            raise ModuleError("for {seconds:.3g} s nothing was seen to go to", seconds=self._unseen)
        if self._time > self.MOST:
            raise ModuleError(
                "after {seconds:.3g} s it is still {away:.1f} pixels away", seconds=self._time, away=self._away()
            )

    def _away(self):
        return float(np.linalg.norm(self.UV - self._goal))
