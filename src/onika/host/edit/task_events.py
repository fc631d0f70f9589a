"""What sessions are told of a task that no application runs: the news of its unit as an event (Table 9)."""

from onika.runtime import news
from onika.wire import event


def told(heard: news.News, at: float) -> tuple[event.Event, ...]:
    """What is told of a piece of news besides the change of state that it may be."""
    match heard:
        case news.Finished():
            return (event.Signalled(heard.subsystem, heard.task, "FINISH", heard.flow, "", at),)
        case news.Signalled():
            return (event.Signalled(heard.subsystem, heard.task, heard.kind, heard.number, heard.text, at),)
        case news.Failed():
            where = (heard.path, heard.line, heard.traceback, at, heard.entry, heard.values)
            return (event.Failed(heard.subsystem, heard.task, f"{heard.entry}: {heard.text}", *where),)
        case news.Asked():
            items = tuple(event.Item(*(getattr(one, name) for name in one.__struct_fields__)) for one in heard.items)
            return (event.Asked(heard.subsystem, heard.task, heard.reason, items, at),)
        case news.Warned():
            return (event.Warned(heard.subsystem, heard.task, heard.text, at),)
        case news.Stepped():
            return (stepped(heard, round(heard.at_ns * 1e-9, 9)),)
    return ()


def stepped(heard: news.Stepped, at: float) -> event.Stepped:
    """A step as an event at this time."""
    measured = (heard.index, heard.step, heard.given, heard.limit, heard.cycles)
    return event.Stepped(heard.subsystem, heard.task, heard.variable, heard.unit, *measured, at)
