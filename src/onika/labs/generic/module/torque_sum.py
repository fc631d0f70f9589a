"""Sum of the torques that go to the robot."""

import numpy as np

from onika.module import InConst, InVar, Module, OutVar


class TorqueSum(Module):
    """The torque a robot is given: the servo's and the model's.

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  NDOF     int           -    number of joints
             INVAR    TAU_PD   double[NDOF]  N m  torque of the servo
             INVAR    TAU_G    double[NDOF]  N m  torque of the model
             OUTVAR   TAU_REF  double[NDOF]  N m  wanted torque
    Source   dissertation §3.2.1
    """

    NDOF = InConst("int", "-", "number of joints")
    TAU_PD = InVar("double[NDOF]", "N m", "torque of the servo")
    TAU_G = InVar("double[NDOF]", "N m", "torque of the model")
    TAU_REF = OutVar("double[NDOF]", "N m", "wanted torque")

    def on(self, inputs):
        self._terms = self.TAU_PD, self.TAU_G, self.TAU_REF  # the same arrays while the task lives
        self.cycle()

    def cycle(self):
        servo, model, wanted = self._terms
        np.add(servo, model, out=wanted)
