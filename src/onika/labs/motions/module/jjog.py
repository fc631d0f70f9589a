"""One joint, led by hand."""

import numpy as np

from onika.laws.signals.limited_rate import LimitedRate
from onika.laws.signals.new_press import NewPress
from onika.module import InConst, Input, InVar, Local, Module, OutVar, finish

STILL = 1e-4  # rad/s


class Jjog(Module):
    """Moves one joint at the speed that the first axis of a pad says, until a button is pressed.

    It slows down before a limit so that it comes to rest there. An axis that is NaN or infinite counts as let go, and
    a button that is pressed already at `on` once it was.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF     int           -      number of joints
             INCONST  QMIN     double[NDOF]  rad    lower joint limits
             INCONST  QMAX     double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX   double[NDOF]  rad/s  highest joint speeds
             INVAR    V_RAW    double[6]     -      axes of the pad, -1..1; the first one counts
             INVAR    BUTTONS  int           -      not 0: it comes to rest and ends
             INVAR    Q_MEZ    double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF    double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF   double[NDOF]  rad/s  reference speed
    Local    SPEED             double        -      share of Q^_MAX at the end of the axis
             RISE              double        s      how long it takes from rest to that speed
    Input    index             int           -      1..NDOF
    Finish   flow 0, loop FALSE, when BUTTONS is not 0 and the joint was brought to rest
    Source   dissertation §4.4
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    V_RAW = InVar("double[6]", "-", "axes of the pad, -1..1; the first one counts")
    BUTTONS = InVar("int", "-", "not 0: it comes to rest and ends")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    SPEED = Local("double", "-", "share of Q^_MAX at the end of the axis", default=0.2, low=0.01, high=1.0)
    RISE = Local("double", "s", "how long it takes from rest to that speed", default=0.3, low=0.01)

    index = Input("int", "-", "which joint, counted from 1", low=1, high="NDOF")

    def on(self, inputs):
        self._joint = joint = int(inputs.index) - 1
        self._press = NewPress(bool(self.BUTTONS))
        self._fastest = self.SPEED * float(self.Qd_MAX[joint])
        self._rise = self._fastest / self.RISE
        self._limited = LimitedRate(np.zeros(1), self._rise)
        self.Q_REF = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self.Qd_REF = 0.0

    def cycle(self):
        is_pressed = self._press.is_there(bool(self.BUTTONS))
        push = float(self.V_RAW[0]) if np.isfinite(self.V_RAW[0]) and not is_pressed else 0.0
        wanted = self._fastest * min(max(push, -1.0), 1.0)
        self._limited.follow(np.array([self._bounded(wanted)]), self.dt)
        joint, speed = self._joint, float(self._limited.value[0])
        low, high = min(self.QMIN[joint], self.Q_REF[joint]), max(self.QMAX[joint], self.Q_REF[joint])
        place = min(max(self.Q_REF[joint] + self.dt * speed, low), high)
        self.Qd_REF[joint] = (place - self.Q_REF[joint]) / self.dt
        self.Q_REF[joint] = place
        return finish() if is_pressed and abs(speed) < STILL else None

    def _bounded(self, wanted):
        """The wanted speed, as fast as the joint can still be stopped before its limit."""
        joint = self._joint
        up = max(float(self.QMAX[joint] - self.Q_REF[joint]), 0.0)
        down = max(float(self.Q_REF[joint] - self.QMIN[joint]), 0.0)
        return min(max(wanted, -self._stopping(down)), self._stopping(up))

    def _stopping(self, room):
        """The speed from which it comes to rest in so much room, though each cycle takes its time."""
        slip = 0.5 * self._rise * self.dt
        return max((slip * slip + 2.0 * self._rise * room) ** 0.5 - 3.0 * slip, 0.0)
