"""Work that takes long and asks no runtime: it is done in a thread of its own, and answered when it is done."""

from collections.abc import Callable, Hashable
from queue import SimpleQueue
from threading import Thread
from typing import Any

from onika.desk.environment.outcome.button_commands import Tell
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.model import Model


class BackgroundWorker:
    """One thing after the other, in the order in which they were asked for.

    tell    how what comes of it gets into the environment's own thread, in order
    name    of the thread
    """

    def __init__(self, tell: Tell, name: str = "aside") -> None:
        self._tell = tell
        self._name = name
        self._asked: SimpleQueue[Callable[[], None] | None] = SimpleQueue()
        self._thread: Thread | None = None
        self._is_closed = False

    def answer(self, work: Callable[[], Any], what: Hashable) -> None:
        """Have something done; its result is the news of `what`."""

        def carry_out() -> None:
            news = ((what, work()),)
            self.tell(lambda model: Done(model, news=news))

        self.do(carry_out)

    def do(self, work: Callable[[], None]) -> None:
        """Have something done of which nobody need hear."""
        if self._thread is None:
            self._thread = Thread(target=self._run, name=self._name, daemon=True)
            self._thread.start()
        self._asked.put(work)

    def tell(self, change: Callable[[Model], Done]) -> None:
        """From within the work: how far it is."""
        if not self._is_closed:
            self._tell(change)

    def close(self) -> None:
        """What has not begun is not begun any more, and nothing more is told."""
        self._is_closed = True
        self._asked.put(None)

    def _run(self) -> None:
        while (work := self._asked.get()) is not None:
            if self._is_closed:
                continue
            try:
                work()
            except BaseException as wrong:
                self._tell(_raising(wrong))


def _raising(wrong: BaseException) -> Callable[[Model], Done]:
    def outcome(_: Model) -> Done:
        raise wrong

    return outcome
