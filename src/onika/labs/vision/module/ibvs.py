"""Visual servoing to a point."""

import numpy as np

from onika.laws.pictures.image_servo import ImageServo
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar, finish

STALE = 0.5  # s: an older picture steers nothing


class Ibvs(Module):
    """Moves the camera in the plane of its picture until a point of the picture is where PLACE says.

    The camera is borne by the tool and looks along its approach. What it moves between a picture and now is counted
    in, so that a late picture does no harm.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  H      int        -          height of a picture in pixels
             INCONST  W      int        -          width of a picture in pixels
             INCONST  FOCAL  double     -          focal length in pixels
             INVAR    UV     double[2]  -          the point in pixels: to the right, down
             INVAR    AREA   double     -          0: it is not seen
             INVAR    IMG_T  double[2]  -,s        how many pictures there were; how old the newest is
             OUTVAR   V_REF  double[6]  m/s,rad/s  wanted speed, along the axes of the tool
    Local    PLACE           double[2]  -          where it is to come: shares of width and height
             NEAR            double     -          how near it has to be in pixels
             COUNT           int        -          in how many pictures one after the other
             GAIN            double     1/s        share of the way that it comes nearer in a second
             DEPTH           double     m          how far away it is, about
             TURN            double     rad        how far the right of the picture is turned from x of the tool
             SPEED           double     m/s        highest speed
             RISE            double     m/s^2      how fast the speed may change
             WAIT            double     s          how long nothing may be seen
             MOST            double     s          how long it may take
    Finish   flow 0, loop FALSE, when it has been that near in COUNT pictures
    Errors   nothing seen    for WAIT seconds the point was not seen, or no picture came: ERROR, the arm stays
             not there       after MOST seconds it has not come to its place: ERROR, the arm stays
    Get/Set  away, in pixels, from the place / -
    Source   dissertation §4.5.3; Chaumette & Hutchinson 2006
    """

    trigger = True

    H = InConst("int", "-", "height of a picture in pixels")
    W = InConst("int", "-", "width of a picture in pixels")
    FOCAL = InConst("double", "-", "focal length in pixels")
    UV = InVar("double[2]", "-", "the point in pixels: to the right, down")
    AREA = InVar("double", "-", "0: it is not seen")
    IMG_T = InVar("double[2]", "-,s", "how many pictures there were; how old the newest is")
    V_REF = OutVar("double[6]", "m/s,rad/s", "wanted speed, along the axes of the tool")

    PLACE = Local("double[2]", "-", "where it is to come: shares of width and height", default=(0.5, 0.5))
    NEAR = Local("double", "-", "how near it has to be in pixels", default=2.0, low=0.1)
    COUNT = Local("int", "-", "in how many pictures one after the other", default=3, low=1, high=1000)
    GAIN = Local("double", "1/s", "share of the way that it comes nearer in a second", default=3.0, low=0.01, high=10.0)
    DEPTH = Local("double", "m", "how far away it is, about", default=0.3, low=0.01, high=100.0)
    TURN = Local("double", "rad", "how far the right of the picture is turned from x of the tool", default=0.0)
    SPEED = Local("double", "m/s", "highest speed", default=0.2, low=1e-3)
    RISE = Local("double", "m/s^2", "how fast the speed may change", default=1.0, low=1e-2)
    WAIT = Local("double", "s", "how long nothing may be seen", default=3.0, low=0.1)
    MOST = Local("double", "s", "how long it may take", default=20.0, low=0.1, high=86_400.0)

    def on(self, inputs):
        self._servo = ImageServo(self.FOCAL, self.DEPTH, self.GAIN, self.TURN, self.SPEED, self.RISE)
        self._goal = np.array(self.PLACE) * (self.W, self.H) - 0.5
        self._number, self._count, self._unseen, self._time = 0.0, 0, 0.0, 0.0
        self.V_REF = 0.0

    def cycle(self):
        is_seen = self.AREA > 0 and self.IMG_T[0] > 0 and self.IMG_T[1] < STALE
        if not is_seen:
            self._servo.lose()
            self._count = 0
        elif self.IMG_T[0] != self._number:
            self._number = self.IMG_T[0]
            self._servo.see(self.UV - self._goal, self.now - self.IMG_T[1])
            self._count = self._count + 1 if self._away() < self.NEAR else 0
        self._unseen = 0.0 if is_seen or not self.IMG_T[0] else self._unseen + self.dt
        if self._unseen > self.WAIT:
            raise ModuleError("for {seconds:.3g} s nothing was seen to go to", seconds=self._unseen)
        if self._count >= self.COUNT:
            self.V_REF = 0.0
            return finish()
        self._time += self.dt
        if self._time > self.MOST:
            raise ModuleError(
                "after {seconds:.3g} s it is still {away:.1f} pixels away", seconds=self._time, away=self._away()
            )
        self.V_REF[:2] = self._servo.move(self.now, self.dt)
        return None

    def get(self, name):
        return self._away() if name == "away" else super().get(name)

    def _away(self):
        return float(np.linalg.norm(self.UV - self._goal))
