"""Pictures of a camera."""

import numpy as np

from onika.module import Local, Module, ModuleError, OutConst, OutVar

LONGEST = 30.0  # s before the first picture: what takes them has to begin


class Camera(Module):
    """The pictures of a camera device, of whatever size and rate it has; several tasks may have one camera.

    Give it a rate of at least that of the camera: a picture is passed on in the cycle after it has come.

    Kind     general, periodic, 1..1000 Hz
    Ports    OUTCONST H      int           -    height of a picture in pixels
             OUTCONST W      int           -    width of a picture in pixels
             OUTCONST FOCAL  double        -    focal length in pixels
             OUTVAR   IMG    byte[H,W,3]   -    the newest picture: rows from the top, red, green, blue
             OUTVAR   IMG_T  double[2]     -,s  how many pictures there were; how old the newest is
    Local    MOST            double        s    how old the newest picture may become
    Errors   no camera       the device takes no pictures: stays uninitialised
             dark            the machine cannot render: ERROR; the log says why
             too old         no picture came for MOST seconds: ERROR
    Source   dissertation §4.5.2
    """

    H = OutConst("int", "-", "height of a picture in pixels")
    W = OutConst("int", "-", "width of a picture in pixels")
    FOCAL = OutConst("double", "-", "focal length in pixels")
    IMG = OutVar("byte[H,W,3]", "-", "the newest picture: rows from the top, red, green, blue")
    IMG_T = OutVar("double[2]", "-,s", "how many pictures there were; how old the newest is")

    MOST = Local("double", "s", "how old the newest picture may become", default=5.0, low=0.1, high=3600.0)

    @classmethod
    def constants(cls, local, identity):
        """Size and focal length, as the camera says them."""
        if "FOCAL" not in identity:
            return {}
        return {"H": int(identity["H"][0]), "W": int(identity["W"][0]), "FOCAL": float(identity["FOCAL"][0])}

    @classmethod
    def fits(cls, constants, identity):
        """Why a device that says this of itself is no camera."""
        return None if "FOCAL" in identity else "expected a camera, found a device that takes no pictures"

    def init(self):
        if not self.device.sheet.picture:
            raise ModuleError("expected a camera, found a device that takes no pictures")
        self.state_constants()

    def on(self, inputs):
        self._number, self._waited = 0.0, 0.0
        self._look()

    def cycle(self):
        self._look()
        self._waited = self._waited + self.dt if not self._number else 0.0
        if self._waited > LONGEST or self.IMG_T[1] > self.MOST:
            raise ModuleError("no picture came for {seconds:.3g} s", seconds=max(self._waited, self.IMG_T[1]))

    def _look(self):
        number, age = self.device.read()
        if self.device.is_tripped:
            raise ModuleError("the camera can take no pictures here; the log says why")
        if number != self._number:
            self.IMG = self.device.picture()
            self._number = number
        self.IMG_T = np.array((number, age))
