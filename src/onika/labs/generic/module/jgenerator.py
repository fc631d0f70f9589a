"""Signal generator for one joint."""

import math

from onika.laws.sentence import no_element
from onika.laws.waveform import PERIODIC, sweep, wave
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar

KINDS = (*PERIODIC, "step", "sweep")


class Jgenerator(Module):
    """Moves one joint about where the arm is, as a test signal for its servo; the others stay where they are.

    q_ref[JOINT] = q0[JOINT] + AMPLITUDE w(t - DELAY), with w between -1 and 1, and 0 before DELAY

    A step is 1 from DELAY on. A sweep is a sine that goes from FREQUENCY to END in LASTS seconds, shortened to whole
    waves, and then rests. A sine and a sweep begin with the speed of the wave, which the servo has to catch up with.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; q0 where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is q0
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed; 0 for a square and a step
    Local    WAVE       string  -    sine, square, triangle, step or sweep
             JOINT      int     -    which joint moves, from 0
             AMPLITUDE  double  rad  half of its height; the height of a step
             FREQUENCY  double  Hz   waves in a second; where a sweep begins
             END        double  Hz   where a sweep ends
             LASTS      double  s    how long a sweep takes
             DELAY      double  s    when it begins, counted from `on`
    Errors   beyond the limits  the joint would leave QMIN..QMAX: stays OFF
             too fast           the wave would be faster than Q^_MAX: stays OFF
    """

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; q0 where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is q0")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed; 0 for a square and a step", name="Q^_REF")

    WAVE = Local("string", "-", "sine, square, triangle, step or sweep", default="sine")
    JOINT = Local("int", "-", "which joint moves, from 0", default=0, low=0, high=31)
    AMPLITUDE = Local("double", "rad", "half of its height; the height of a step", default=0.05, low=-0.5, high=0.5)
    FREQUENCY = Local("double", "Hz", "waves in a second; where a sweep begins", default=0.5, low=0.01, high=50.0)
    END = Local("double", "Hz", "where a sweep ends", default=5.0, low=0.01, high=50.0)
    LASTS = Local("double", "s", "how long a sweep takes", default=20.0, low=0.1, high=600.0)
    DELAY = Local("double", "s", "when it begins, counted from `on`", default=0.5, low=0.0, high=60.0)

    def init(self):
        if self.WAVE not in KINDS:
            raise ModuleError("WAVE: expected one of {kinds}, found {found}", kinds=" ".join(KINDS), found=self.WAVE)
        if why := no_element("JOINT", self.JOINT, self.NDOF):
            raise ModuleError(why)

    def on(self, inputs):
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._check_place(float(start[self.JOINT]))
        self._check_speed()
        self._start, self._steps = start, 0
        self.Q_REF = start
        self.Qd_REF = 0.0

    def cycle(self):
        level, slope = self._level(self._steps * self.dt - self.DELAY)
        self._steps += 1
        self.Q_REF[self.JOINT] = self._start[self.JOINT] + self.AMPLITUDE * level
        self.Qd_REF[self.JOINT] = self.AMPLITUDE * slope

    def _level(self, time):
        """The signal without its height, and its slope per second, so long after it began."""
        if time < -self.dt / 2.0:
            return 0.0, 0.0
        if self.WAVE == "step":
            return 1.0, 0.0
        if self.WAVE == "sweep":
            turns, rate = sweep(max(time, 0.0), self.FREQUENCY, self.END, self.LASTS)
            return wave("sine", turns, rate)
        return wave(self.WAVE, max(time, 0.0) * self.FREQUENCY, self.FREQUENCY)

    def _check_place(self, middle):
        low = middle + min(0.0, self.AMPLITUDE) if self.WAVE == "step" else middle - abs(self.AMPLITUDE)
        high = middle + max(0.0, self.AMPLITUDE) if self.WAVE == "step" else middle + abs(self.AMPLITUDE)
        least, most = float(self.QMIN[self.JOINT]), float(self.QMAX[self.JOINT])
        if low < least or high > most:
            raise ModuleError(
                "joint {joint} would go to {low:.3f}..{high:.3f} rad, and may go to {least:.3f}..{most:.3f} rad",
                joint=self.JOINT,
                low=low,
                high=high,
                least=least,
                most=most,
            )

    def _check_speed(self):
        if self.WAVE not in ("sine", "triangle", "sweep"):
            return
        quickest = max(self.FREQUENCY, self.END) if self.WAVE == "sweep" else self.FREQUENCY
        slope = 4.0 if self.WAVE == "triangle" else 2.0 * math.pi
        speed, most = abs(self.AMPLITUDE) * slope * quickest, float(self.Qd_MAX[self.JOINT])
        if speed > most:
            raise ModuleError(
                "joint {joint} would move at {speed:.3f} rad/s, and may move at {most:.3f} rad/s",
                joint=self.JOINT,
                speed=speed,
                most=most,
            )
