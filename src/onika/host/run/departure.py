"""The departure of whoever began a run: what its engine is then told (requirement X12)."""

from collections.abc import Iterable

from onika.engine.news import Abort
from onika.wire.steer import Pause
from onika.words.reason import Reason


def after_departure(on_loss: str, subsystems: Iterable[str], cause: Reason) -> tuple[Abort | Pause, ...]:
    """As it was begun: it ends, every flow finishes its action and pauses, or it goes on and nothing is told."""
    if on_loss == "stop":
        return (Abort(cause),)
    if on_loss == "finish":
        return tuple(Pause(subsystem) for subsystem in subsystems)
    return ()
