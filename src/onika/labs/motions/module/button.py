"""A wait for a button."""

from onika.laws.signals.new_press import NewPress
from onika.module import InVar, Local, Module, finish


class ButtonWait(Module):
    """Ends a job when somebody presses a button, as where the tool was led to its place.

    A button that is pressed already at `on` counts once it was let go.

    Kind     trigger, periodic, 1..1000 Hz
    Ports    INVAR  BUTTONS  int     -  not 0 while one is pressed
    Local    SETTLE          double  s  how long it has to be pressed: what is led comes to rest
    Finish   flow 0, loop FALSE, when BUTTONS has not been 0 for SETTLE
    Source   dissertation §6.2.2.3
    """

    trigger = True

    BUTTONS = InVar("int", "-", "not 0 while one is pressed")

    SETTLE = Local("double", "s", "how long it has to be pressed: what is led comes to rest", default=0.5, low=0.0)

    def on(self, inputs):
        self._press, self._pressed = NewPress(bool(self.BUTTONS)), 0.0

    def cycle(self):
        is_pressed = self._press.is_there(bool(self.BUTTONS))
        self._pressed = self._pressed + self.dt if is_pressed else 0.0
        return finish() if self._pressed > max(self.SETTLE - self.dt / 2.0, 0.0) else None
