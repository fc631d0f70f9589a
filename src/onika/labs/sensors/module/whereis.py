"""Where a thing is."""

from onika.laws.frames import rotation_of_quaternion
from onika.module import Local, Module, ModuleError, OutVar

POSE = 7  # x y z and a quaternion


class Whereis(Module):
    """Where a thing is in the world, as a device of the world measures it.

    Kind     general, periodic, 10..1000 Hz
    Ports    OUTVAR  X_PART  double[4,4]  -  pose of the thing in the world, position in m
    Local    NOISE           double       m  how much its position is measured wrong, as a standard deviation
    Errors   another device  the device does not publish a pose: stays uninitialised
    """

    X_PART = OutVar("double[4,4]", "-", "pose of the thing in the world, position in m")

    NOISE = Local(
        "double", "m", "how much its position is measured wrong, as a standard deviation", default=0.0, low=0.0
    )

    def init(self):
        published = len(self.device.sheet.state) - 2
        if published != POSE:
            raise ModuleError(
                "expected a device that publishes the {expected} numbers of a pose, "
                "found one that publishes {published}",
                expected=POSE,
                published=published,
            )

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        pose = self.device.read()
        self.X_PART[:3, :3] = rotation_of_quaternion(pose[3:])
        self.X_PART[:3, 3] = pose[:3]
        self.X_PART[3, 3] = 1.0
        for axis in range(3 if self.NOISE else 0):
            self.X_PART[axis, 3] += self.random.gauss(0.0, self.NOISE)
