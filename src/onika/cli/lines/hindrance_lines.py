"""What was in the way of an arm whose run has failed, in one line behind the error (requirement X06)."""

from collections.abc import Callable

from onika.wire import event
from onika.words.reason import Reason

_NEAR_S = 1.0  # how long after an error the drive holds that it has stopped


class HindranceLines:
    """Remembers when a task failed: an arm that holds for another reason may touch what it is to touch."""

    def __init__(self) -> None:
        self._failed_s: float | None = None

    def line(self, happening: event.Event, say: Callable[[Reason], str]) -> str:
        """The line behind this event, in the words of `say`; empty for nearly all."""
        if isinstance(happening, event.Failed):
            self._failed_s = happening.at_s
        if not isinstance(happening, event.Drive) or not happening.touches or self._failed_s is None:
            return ""
        if happening.at_s - self._failed_s > _NEAR_S:
            return ""
        return f"{happening.at_s:8.2f} s  {say(Reason.of('cli.drive_touches', touches=happening.touches))}"
