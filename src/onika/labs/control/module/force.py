"""A force that is held along one direction of a motion."""

import numpy as np

from onika.laws.paths.pressing import Pressing
from onika.module import InVar, Local, Module, OutVar


class ForceHeld(Module):
    """Holds a force along AXIS of the world while the tool goes on its path across it.

    It leaves its path along AXIS as the force lacks, no faster than SPEED and no further than FAR. Forces count from
    those that it feels when it comes on.

    Kind     general, periodic, 50..1000 Hz
    Ports    INVAR   X_REF  double[4,4]  -      reference pose, of the path
             INVAR   F_MEZ  double[6]    N,N m  force on the tool and torque about it, along the axes of the world
             OUTVAR  X_OUT  double[4,4]  -      reference pose that holds the force
    Local    AXIS           double[3]    -      where the tool presses, of any length
             FORCE          double       N      with how much
             GAIN           double       m/s/N  how fast it goes for a force that lacks
             SPEED          double       m/s    the highest speed along AXIS
             FAR            double       m      how far it leaves the path at most
    Get/Set  lacks, in N / -
    Errors   no number      a force that is NaN or infinite counts as none that is felt
    Source   Raibert & Craig 1981; Craig, Introduction to Robotics, §11
    """

    X_REF = InVar("double[4,4]", "-", "reference pose, of the path")
    F_MEZ = InVar("double[6]", "N,N m", "force on the tool and torque about it, along the axes of the world")
    X_OUT = OutVar("double[4,4]", "-", "reference pose that holds the force")

    AXIS = Local("double[3]", "-", "where the tool presses, of any length", default=(0.0, 0.0, -1.0))
    FORCE = Local("double", "N", "with how much", default=10.0, low=0.1, high=200.0)
    GAIN = Local("double", "m/s/N", "how fast it goes for a force that lacks", default=4e-4, low=1e-7)
    SPEED = Local("double", "m/s", "the highest speed along AXIS", default=0.02, low=1e-4)
    FAR = Local("double", "m", "how far it leaves the path at most", default=0.05, low=1e-3)

    def init(self):
        self._axis = np.asarray(self.AXIS) / max(float(np.linalg.norm(self.AXIS)), 1e-9)

    def on(self, inputs):
        self._pressing = Pressing(self.FORCE * self._axis, self.SPEED, self.GAIN)
        self._at_first, self._away = self._felt(), 0.0
        self.X_OUT = self.X_REF

    def cycle(self):
        step = float(self._axis @ self._pressing.step(self._felt() - self._at_first, self.dt))
        self._away = float(np.clip(self._away + step, -self.FAR, self.FAR))
        self.X_OUT = self.X_REF
        self.X_OUT[:3, 3] += self._away * self._axis

    def get(self, name):
        return self._pressing.lacks(self._felt() - self._at_first) if name == "lacks" else super().get(name)

    def _felt(self):
        return np.where(np.isfinite(self.F_MEZ[:3]), self.F_MEZ[:3], 0.0)
