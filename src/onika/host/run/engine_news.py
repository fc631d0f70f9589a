"""Engine news: what the news of a task means to the engine (law 28)."""

from onika.engine import news as engine_news
from onika.model.lifecycle import State
from onika.runtime import news
from onika.words.reason import Reason

_REFUSALS = ("on", "spawn", "clear")
"""The commands of the engine that a task may refuse."""

_ENDS_WORK = ("ILLEGAL", "SHUTDOWN")
"""The signals after which the robot may not go on."""


def of_task(flow: int, message: news.TaskNews, before: State) -> engine_news.News | None:
    """The engine's news of a task that was in the state `before`; None where it does not matter to the engine."""
    task = message.task
    if type(message) is news.Cycled:
        return None
    match message:
        case news.Finished():
            return engine_news.Finished(flow, task, message.flow, message.loop, message.switched)
        case news.Initialised():
            return _off(flow, task, before)
        case news.Changed():
            return _changed(flow, message, before)
        case news.Failed():
            return engine_news.Failed(flow, task, _failure(message))
        case news.Asked():
            return engine_news.Asked(flow, task, message.reason)
        case news.Signalled() if message.kind in _ENDS_WORK:
            said = Reason.of("host.signal_said", signal=message.kind, text=message.text)
            return engine_news.Illegal(flow, task, said)
        case news.Refused() if message.command in _REFUSALS:
            refusal = Reason.of("host.entry_failed", entry=message.command, why=message.reason)
            return engine_news.Refused(flow, task, refusal)
    return None


def _failure(message: news.Failed) -> Reason:
    """What has failed, and where in the module's code."""
    if not message.line:
        return Reason.of("host.entry_failed", entry=message.entry, why=message.text)
    line = str(message.line)
    return Reason.of("host.entry_failed_at", entry=message.entry, why=message.text, path=message.path, line=line)


def _changed(flow: int, message: news.Changed, before: State) -> engine_news.News | None:
    if message.state == State.ON.value:
        return engine_news.TurnedOn(flow, message.task)
    if message.state == State.KILLED.value:
        return engine_news.Killed(flow, message.task)
    if before not in (State.WAITING, State.ERROR) and message.signal == "OFF":
        return engine_news.SwitchedOff(flow, message.task)
    return _off(flow, message.task, before)


def _off(flow: int, task: str, before: State) -> engine_news.News | None:
    if before is State.WAITING:
        return engine_news.Spawned(flow, task)
    if before is State.ERROR:
        return engine_news.Cleared(flow, task)
    return None
