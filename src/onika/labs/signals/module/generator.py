"""Signal generator."""

from onika.laws.waveform import PERIODIC, sweep, wave
from onika.module import Local, Module, ModuleError, OutVar

KINDS = (*PERIODIC, "step", "sweep")


class Generator(Module):
    """Drives a variable that nobody else writes: sine, square, triangle, step or sweep.

    SIGNAL = OFFSET + AMPLITUDE w(t - DELAY), with w between -1 and 1, and 0 before DELAY

    A step is 1 from DELAY on. A sweep is a sine that goes from FREQUENCY to END in LASTS seconds, shortened to whole
    waves, and then rests at OFFSET. A new frequency goes on where the wave stands.

    Kind     general, periodic, 1..1000 Hz
    Ports    OUTVAR   SIGNAL  double  -  the signal; by an alias any variable of this type and unit
    Local    WAVE       string  -   sine, square, triangle, step or sweep
             AMPLITUDE  double  -   half of its height; the height of a step
             OFFSET     double  -   what it swings about
             FREQUENCY  double  Hz  waves in a second; where a sweep begins
             END        double  Hz  where a sweep ends
             LASTS      double  s   how long a sweep takes
             DELAY      double  s   when it begins, counted from `on`
    Get/Set  AMPLITUDE, OFFSET, FREQUENCY / the same, at once, without a new beginning
    """

    SIGNAL = OutVar("double", "-", "the signal; by an alias any variable of this type and unit")

    WAVE = Local("string", "-", "sine, square, triangle, step or sweep", default="sine")
    AMPLITUDE = Local("double", "-", "half of its height; the height of a step", default=1.0, low=0.0, high=10.0)
    OFFSET = Local("double", "-", "what it swings about", default=0.0, low=-10.0, high=10.0)
    FREQUENCY = Local("double", "Hz", "waves in a second; where a sweep begins", default=1.0, low=0.01, high=100.0)
    END = Local("double", "Hz", "where a sweep ends", default=10.0, low=0.01, high=100.0)
    LASTS = Local("double", "s", "how long a sweep takes", default=10.0, low=0.1, high=600.0)
    DELAY = Local("double", "s", "when it begins, counted from `on`", default=0.0, low=0.0, high=60.0)

    def init(self):
        if self.WAVE not in KINDS:
            raise ModuleError("WAVE: expected one of {kinds}, found {found}", kinds=" ".join(KINDS), found=self.WAVE)

    def on(self, inputs):
        self._steps, self._turns = 0, 0.0
        self.SIGNAL = self.OFFSET

    def cycle(self):
        time = self._steps * self.dt - self.DELAY
        self._steps += 1
        self.SIGNAL = self.OFFSET + self.AMPLITUDE * self._level(time)

    def get(self, name):
        if name in ("AMPLITUDE", "OFFSET", "FREQUENCY"):
            return getattr(self, name)
        return super().get(name)

    def set(self, name, value):
        declared = self.declared_locals.get(name)
        if declared is None or name not in ("AMPLITUDE", "OFFSET", "FREQUENCY"):
            return super().set(name, value)
        number = declared.shape.type.parse(value)
        if not declared.low <= number <= declared.high:
            bounds = {"low": declared.low, "high": declared.high}
            raise ModuleError(
                "{name}: expected {low:g}..{high:g}, found {number:g}", name=name, number=number, **bounds
            )
        setattr(self, name, number)
        return None

    def _level(self, time):
        """The signal without height and offset, so long after it began."""
        if time < -self.dt / 2.0:
            return 0.0
        if self.WAVE == "step":
            return 1.0
        if self.WAVE == "sweep":
            turns, rate = sweep(max(time, 0.0), self.FREQUENCY, self.END, self.LASTS)
            return wave("sine", turns, rate)[0]
        level, _ = wave(self.WAVE, self._turns, self.FREQUENCY)
        self._turns += self.FREQUENCY * self.dt
        return level
