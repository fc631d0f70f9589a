"""Strokes of a pad that nobody holds."""

from onika.module import Local, Module, ModuleError, OutVar

AXES = 6
NOTHING, BUTTON = -1, -2  # in place of an axis


class Strokes(Module):
    """Moves the six axes of a pad as it was told, one stroke behind the other, then presses its button; and again.

    To try teleoperation where there is no pad, or nobody at it. A stroke is AXIS:LEVEL:SECONDS, the axis counted from
    0, its level -1..1; axis `-` leaves the pad alone.

    Kind     general, periodic, 20..1000 Hz
    Ports    OUTVAR  V_RAW    double[6]  -  axes of the pad, -1..1
             OUTVAR  BUTTONS  int        -  1 for PRESS behind the last stroke, else 0
    Local    STROKES          line       -  strokes, parted by blanks, as 2:0.5:1.5
             PRESS            double     s  how long the button is pressed
    Errors   no stroke  a word of STROKES is none: stays uninitialised
    """

    V_RAW = OutVar("double[6]", "-", "axes of the pad, -1..1")
    BUTTONS = OutVar("int", "-", "1 for PRESS behind the last stroke, else 0")

    STROKES = Local("line", "-", "strokes, parted by blanks, as 2:0.5:1.5", default="-:0:1")
    PRESS = Local("double", "s", "how long the button is pressed", default=1.0, low=0.01, high=3600.0)

    def init(self):
        strokes = [self._stroke(word) for word in self.STROKES.split()]
        self._strokes = [*strokes, (BUTTON, 0.0, self.PRESS)]

    def on(self, inputs):
        self._left, self._time = list(self._strokes), 0.0
        self.V_RAW = 0.0
        self.BUTTONS = 0

    def cycle(self):
        self._time += self.dt
        while self._time > self._left[0][2] + self.dt / 2.0:  # sums of periods are not exact
            self._time -= self._left.pop(0)[2]
            self._left = self._left or list(self._strokes)
        axis, level, _ = self._left[0]
        self.BUTTONS = int(axis == BUTTON)
        self.V_RAW = 0.0
        if axis in range(AXES):
            self.V_RAW[axis] = level

    def _stroke(self, word):
        """Axis, level and seconds of a word."""
        axis, _, rest = word.partition(":")
        level, _, seconds = rest.partition(":")
        try:
            stroke = NOTHING if axis == "-" else int(axis), float(level), float(seconds)
        except ValueError:
            stroke = AXES, 0.0, 0.0
        is_axis = axis == "-" or stroke[0] in range(AXES)
        if not is_axis or not (abs(stroke[1]) <= 1.0 and 0.0 < stroke[2] < 3600.0):
            raise ModuleError("STROKES: expected AXIS:LEVEL:SECONDS, as 2:0.5:1.5, found {word}", word=word)
        return stroke
