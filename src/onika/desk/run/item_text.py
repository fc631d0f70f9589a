"""The values that a task asks for, in words: between which bounds they lie, and which count where none are given."""

from collections.abc import Iterable

from onika.wire import event
from onika.words.reason import NOTHING, Reason


def bounds(item: event.Item) -> Reason:
    """Between which values it lies; nothing where it has no bounds."""
    if item.low is not None and item.high is not None:
        return Reason.of("desk.item_range", low=_numbers(item.low), high=_numbers(item.high))
    if item.low is not None:
        return Reason.of("desk.item_least", low=_numbers(item.low))
    if item.high is not None:
        return Reason.of("desk.item_most", high=_numbers(item.high))
    return NOTHING


def default(item: event.Item) -> Reason:
    """What it is if nothing is answered; nothing where an answer is needed."""
    if item.default is None:
        return NOTHING
    return Reason.of("desk.item_default", values=" ".join(map(str, item.default)))


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{value:g}" for value in values)
