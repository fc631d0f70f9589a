"""What a task asks, as a page shows it: of a document, of a run, of a run that another began."""

from collections.abc import Mapping, Sequence

from onika.wire import event
from onika.wire.view import AskItem, AskView


def ask_view(question: event.Asked, present: Mapping[str, Sequence[float]] | None = None) -> AskView:
    """A question; `present` is where the robot stands, by the names of the inputs."""
    items = tuple(
        AskItem(item.name, item.type, item.count, item.unit, item.meaning, item.default, item.low, item.high)
        for item in question.items
    )
    return AskView(items, question.reason, {name: tuple(values) for name, values in (present or {}).items()})
