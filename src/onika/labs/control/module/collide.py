"""A watch for collisions."""

import numpy as np

from onika.module import InConst, InVar, Local, Module, OutVar


class Collide(Module):
    """Tells that an arm presses against something: its servo has to do more than the model of the arm explains.

    Where the model bears weight and friction, the servo's torque is small while nothing is in the way. HIT rises once
    it was above a share of TAUMAX for a while, in any joint, and stays until the next `on`. What is carried and not
    known counts as something in the way.

    Kind     general, periodic, 50..1000 Hz
    Ports    INCONST  NDOF    int           -    number of joints
             INCONST  TAUMAX  double[NDOF]  N m  highest joint torques
             INVAR    TAU_PD  double[NDOF]  N m  torque of the servo
             OUTVAR   HIT     int           -    1 since something was hit, else 0
    Local    SHARE            double        -    share of TAUMAX above which the servo has something in its way
             LASTS            double        s    for how long it has to be above it
    Get/Set  joint, counted from 1, that was hit first; 0: none / -
    Source   Haddadin, De Luca & Albu-Schäffer, Robot Collisions, IEEE T-RO 33, 2017
    """

    NDOF = InConst("int", "-", "number of joints")
    TAUMAX = InConst("double[NDOF]", "N m", "highest joint torques")
    TAU_PD = InVar("double[NDOF]", "N m", "torque of the servo")
    HIT = OutVar("int", "-", "1 since something was hit, else 0")

    SHARE = Local(
        "double", "-", "share of TAUMAX above which the servo has something in its way", default=0.2, low=1e-3
    )
    LASTS = Local("double", "s", "for how long it has to be above it", default=0.05, low=0.0, high=10.0)

    def on(self, inputs):
        self._above = np.zeros(self.NDOF)  # for how long each joint has been above its share
        self._joint = 0
        self.HIT = 0

    def cycle(self):
        is_above = np.abs(self.TAU_PD) > self.SHARE * self.TAUMAX
        self._above = np.where(is_above, self._above + self.dt, 0.0)
        if self.HIT == 0 and self._above.max() > max(self.LASTS - self.dt / 2.0, 0.0):
            self._joint = int(self._above.argmax()) + 1
            self.HIT = 1

    def get(self, name):
        return self._joint if name == "joint" else super().get(name)
