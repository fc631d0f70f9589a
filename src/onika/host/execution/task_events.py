"""Task events: what sessions are told of a task, made of the news of its unit (Table 9)."""

from collections.abc import Callable

from msgspec import structs

from onika.runtime import news
from onika.wire import event
from onika.words.reason import NOTHING, Reason

TaskEvent = Callable[[news.TaskNews, float], event.Event | None]
"""Makes the event of a piece of news at a time in seconds; None where nothing is told but the change of state."""


_TOLD_IN_A_RUN = frozenset((news.Failed, news.Warned, news.Stepped))


def by_hand(message: news.TaskNews, at_s: float) -> event.Event | None:
    """The event of a task that no application runs: every signal is told."""
    match message:
        case news.Finished():
            return event.Signalled(message.subsystem, message.task, "FINISH", message.flow, NOTHING, at_s)
        case news.Signalled():
            return event.Signalled(message.subsystem, message.task, message.kind, message.number, message.text, at_s)
        case news.Failed():
            return _failed(message, at_s)
        case news.Warned():
            return event.Warned(message.subsystem, message.task, message.text, at_s)
        case news.Stepped():
            return _stepped(message, at_s)
    return None


def in_a_run(message: news.TaskNews, at_s: float) -> event.Event | None:
    """The event of an application's task: signals are answered by the engine; only a step that is too far is told."""
    if type(message) not in _TOLD_IN_A_RUN:
        return None
    match message:
        case news.Failed() | news.Warned():
            return by_hand(message, at_s)
        case news.Stepped():
            stepped = _stepped(message, at_s)
            return stepped if stepped.is_too_far else None
    return None


def question_of(message: news.Asked, at_s: float) -> event.Asked:
    """The question of a task, as users see it."""
    items = tuple(event.Item(*structs.astuple(item)) for item in message.items)
    return event.Asked(message.subsystem, message.task, message.reason, items, at_s)


def _failed(message: news.Failed, at_s: float) -> event.Failed:
    return event.Failed(
        subsystem=message.subsystem,
        task=message.task,
        text=Reason.of("host.entry_failed", entry=message.entry, why=message.text),
        path=message.path,
        line=message.line,
        traceback=message.traceback,
        at_s=at_s,
        entry=message.entry,
        values=message.values,
    )


def _stepped(message: news.Stepped, at_s: float) -> event.Stepped:
    return event.Stepped(
        subsystem=message.subsystem,
        task=message.task,
        variable=message.variable,
        unit=message.unit,
        index=message.index,
        step=message.step,
        given=message.given,
        limit=message.limit,
        cycles=message.cycles,
        at_s=at_s,
    )
