"""Visual servoing to a point that was clicked in the picture."""

import numpy as np

from onika.laws.pictures.image_servo import ImageServo
from onika.laws.pictures.patch import PicturePatch
from onika.module import InConst, Input, InVar, Local, Module, ModuleError, OutVar, finish

STALE = 0.5  # s: an older picture steers nothing


class ToPoint(Module):
    """Moves the camera until a point of its picture, given in pixels, is where PLACE says.

    The point is found again in every picture by what is around it. The camera is borne by the tool and looks along its
    approach.

    Kind     trigger, periodic, 20..200 Hz
    Ports    INCONST  H      int          -          height of a picture in pixels
             INCONST  W      int          -          width of a picture in pixels
             INCONST  FOCAL  double       -          focal length in pixels
             INVAR    IMG    byte[H,W,3]  -          the newest picture
             INVAR    IMG_T  double[2]    -,s        how many pictures there were; how old the newest is
             OUTVAR   UV     double[2]    -          the point in pixels: to the right, down
             OUTVAR   V_REF  double[6]    m/s,rad/s  wanted speed, along the axes of the tool
    Local    PLACE           double[2]    -          where it is to come: shares of width and height
             NEAR            double       -          how near it has to be in pixels
             COUNT           int          -          in how many pictures one after the other
             GAIN            double       1/s        share of the way that it comes nearer in a second
             DEPTH           double       m          how far away it is, about
             TURN            double       rad        how far the right of the picture is turned from x of the tool
             SPEED           double       m/s        highest speed
             RISE            double       m/s^2      how fast the speed may change
             WAIT            double       s          how long it may be lost
             MOST            double       s          how long it may take
    Input    point           double[2]    -          0..639 pixels to the right and down
    Finish   flow 0, loop FALSE, when it has been that near in COUNT pictures
    Errors   nothing there   all is alike around the point, or it lies beside the picture: ERROR
             lost            for WAIT seconds it was not found, or no picture came: ERROR, the arm stays
             not there       after MOST seconds it has not come to its place: ERROR, the arm stays
    Get/Set  away, in pixels, from the place / -
    Source   dissertation §4.5.2, §4.5.3
    """

    trigger = True

    H = InConst("int", "-", "height of a picture in pixels")
    W = InConst("int", "-", "width of a picture in pixels")
    FOCAL = InConst("double", "-", "focal length in pixels")
    IMG = InVar("byte[H,W,3]", "-", "the newest picture")
    IMG_T = InVar("double[2]", "-,s", "how many pictures there were; how old the newest is")
    UV = OutVar("double[2]", "-", "the point in pixels: to the right, down")
    V_REF = OutVar("double[6]", "m/s,rad/s", "wanted speed, along the axes of the tool")

    PLACE = Local("double[2]", "-", "where it is to come: shares of width and height", default=(0.5, 0.5))
    NEAR = Local("double", "-", "how near it has to be in pixels", default=2.0, low=0.1)
    COUNT = Local("int", "-", "in how many pictures one after the other", default=3, low=1, high=1000)
    GAIN = Local("double", "1/s", "share of the way that it comes nearer in a second", default=3.0, low=0.01, high=10.0)
    DEPTH = Local("double", "m", "how far away it is, about", default=0.3, low=0.01, high=100.0)
    TURN = Local("double", "rad", "how far the right of the picture is turned from x of the tool", default=0.0)
    SPEED = Local("double", "m/s", "highest speed", default=0.2, low=1e-3)
    RISE = Local("double", "m/s^2", "how fast the speed may change", default=1.0, low=1e-2)
    WAIT = Local("double", "s", "how long it may be lost", default=3.0, low=0.1)
    MOST = Local("double", "s", "how long it may take", default=20.0, low=0.1, high=86_400.0)

    point = Input("double[2]", "-", "pixels to the right and down", low=0.0, high=639.0)

    def on(self, inputs):
        self._servo = ImageServo(self.FOCAL, self.DEPTH, self.GAIN, self.TURN, self.SPEED, self.RISE)
        self._goal = np.array(self.PLACE) * (self.W, self.H) - 0.5
        self._point, self._patch = np.array(inputs.point), None
        self._number, self._count, self._unseen, self._time = 0.0, 0, 0.0, 0.0
        self.UV = self._point
        self.V_REF = 0.0

    def cycle(self):
        is_new = self.IMG_T[0] > 0 and self.IMG_T[0] != self._number and self.IMG_T[1] < STALE
        is_found = self._find() if is_new else self._unseen == 0.0 and self.IMG_T[1] < STALE
        self._unseen = 0.0 if is_found else self._unseen + self.dt
        if not is_found:
            self._servo.lose()
            self._count = 0
        if self._unseen > self.WAIT:
            raise ModuleError("the point was lost for {seconds:.3g} s", seconds=self._unseen)
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

    def _find(self):
        """Look for the point in a new picture; it is taken from the first one."""
        self._number = self.IMG_T[0]
        if self._patch is None:
            self._patch = self._around()
        elif not self._patch.find(self.IMG):
            return False
        self.UV = np.array(self._patch.at)
        self._servo.see(self.UV - self._goal, self.now - self.IMG_T[1])
        self._count = self._count + 1 if self._away() < self.NEAR else 0
        return True

    def _around(self):
        u, v = self._point
        try:
            return PicturePatch(self.IMG, u, v)
        except ValueError:
            raise ModuleError("there is nothing at {u:.0f} {v:.0f} that could be found again", u=u, v=v) from None

    def _away(self):
        return float(np.linalg.norm(self.UV - self._goal))
