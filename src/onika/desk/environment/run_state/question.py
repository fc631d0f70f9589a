"""What a task asks, as a page shows it: of a document, of a run, of a run that another began."""

from collections.abc import Mapping, Sequence

from onika.wire import event
from onika.wire.view import AskItem, AskView


def ask_view(told: event.Asked, present: Mapping[str, Sequence[float]] | None = None) -> AskView:
    """A question; `present` is where the robot stands, by the names of the inputs."""
    items = tuple(
        AskItem(one.name, one.type, one.count, one.unit, one.meaning, one.default, one.low, one.high)
        for one in told.items
    )
    return AskView(items, told.reason, {name: tuple(values) for name, values in (present or {}).items()})
