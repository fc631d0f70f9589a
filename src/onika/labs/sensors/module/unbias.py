"""What presses on a tool, from a sensor at the wrist."""

import numpy as np

from onika.module import InVar, Local, Module, OutVar

GRAVITY = 9.81  # m/s2


class Unbias(Module):
    """Force and torque on what hangs at a sensor, without its weight and without what the sensor shows by itself.

    What the sensor shows by itself is the mean of the first ZERO seconds, less the weight: nothing may touch the tool
    then. F_RAW is along the axes of the sensor, the result along those of the world, about the sensor.

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   F_RAW  double[6]    N,N m  force and torque, with the weight of what hangs there
             INVAR   X_MEZ  double[4,4]  -      pose of the sensor, or of a tool that is turned as it is
             OUTVAR  F_MEZ  double[6]    N,N m  force and torque, along the axes of the world; 0 for ZERO
    Local    MASS           double       kg     what hangs at the sensor
             CENTRE         double[3]    m      its centre, in the frame of the sensor
             ZERO           double       s      how long is looked at what the sensor shows by itself
    Get/Set  offset, the largest element of it, in N or N m / -
    Source   Craig, Introduction to Robotics, §5.9
    """

    F_RAW = InVar("double[6]", "N,N m", "force and torque, with the weight of what hangs there")
    X_MEZ = InVar("double[4,4]", "-", "pose of the sensor, or of a tool that is turned as it is")
    F_MEZ = OutVar("double[6]", "N,N m", "force and torque, along the axes of the world; 0 for ZERO")

    MASS = Local("double", "kg", "what hangs at the sensor", default=0.0, low=0.0, high=1000.0)
    CENTRE = Local("double[3]", "m", "its centre, in the frame of the sensor", default=(0.0, 0.0, 0.0))
    ZERO = Local("double", "s", "how long is looked at what the sensor shows by itself", default=0.2, low=0.0)

    def on(self, inputs):
        self._offset, self._looks = np.zeros(6), 0
        self.F_MEZ = 0.0

    def cycle(self):
        turn = self.X_MEZ[:3, :3]
        weight = turn.T @ np.array([0.0, 0.0, -self.MASS * GRAVITY])
        borne = np.concatenate([weight, np.cross(self.CENTRE, weight)])
        if self._looks * self.dt < self.ZERO - self.dt / 2.0:
            self._looks += 1
            self._offset += (self.F_RAW - borne - self._offset) / self._looks
            return
        felt = self.F_RAW - borne - self._offset
        self.F_MEZ[:3], self.F_MEZ[3:] = turn @ felt[:3], turn @ felt[3:]

    def get(self, name):
        return float(np.abs(self._offset).max()) if name == "offset" else super().get(name)
