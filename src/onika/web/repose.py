"""The repose of an environment: nobody does anything, nothing runs, so it costs next to nothing (requirement X25).

Whoever comes, or does anything, finds it awake at once.
"""

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Protocol

from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.state.model import Model
from onika.wire import act

UNTOUCHED_S = 60.0
"""So long nobody does anything at a page that is open."""
ALONE_S = 5.0
"""So long no page is open: what fell at the end of a run lies by then."""
_SLOWER = 20.0
_LOOK_S = 1.0
_STANDING = frozenset(("", "OFF", "ERROR"))


class ResidentRuntime(Protocol):
    """The runtime of an environment."""

    def rest(self) -> None:
        """It may rest."""
        ...

    def wake(self) -> None:
        """It may not."""
        ...


class Repose:
    """Follows what is done in an environment; `clock` tells seconds that never go back."""

    def __init__(self, runtime: ResidentRuntime, clock: Callable[[], float]) -> None:
        self._runtime = runtime
        self._clock = clock
        self._touched_s = clock()
        self._woken: asyncio.Event | None = None
        """Set where it ends; None: it is awake."""

    @property
    def goes_on(self) -> bool:
        """Whether it reposes."""
        return self._woken is not None

    def begun(self, _command: act.AnyAct, _by: str) -> Callable[[ActAnswer], None]:
        """An act begins: somebody is at work."""
        self._touch()
        return lambda _given: self._touch()

    def changed(self, before: Model, after: Model) -> None:
        """Somebody has opened a page, or closed it; something has begun to run."""
        if before.people != after.people or is_at_work(after):
            self._touch()

    def look(self, model: Model) -> None:
        """Begin it where it is time."""
        patience_s = UNTOUCHED_S if model.people else ALONE_S
        if not self.goes_on and self._clock() - self._touched_s >= patience_s and not is_at_work(model):
            self._woken = asyncio.Event()
            self._runtime.rest()

    async def keep(self, model: Callable[[], Model]) -> None:
        """Look for it, until it is cancelled."""
        while True:
            await self.pause(_LOOK_S)
            self.look(model())

    async def pause(self, seconds: float) -> None:
        """Wait so long; in repose far longer, but not beyond its end."""
        if self._woken is None:
            await asyncio.sleep(seconds)
            return
        with suppress(TimeoutError):
            await asyncio.wait_for(self._woken.wait(), seconds * _SLOWER)

    def _touch(self) -> None:
        self._touched_s = self._clock()
        if self._woken is not None:
            self._woken.set()
            self._woken = None
            self._runtime.wake()


def is_at_work(model: Model) -> bool:
    """Whether anything runs or is about to: an application, or a task by hand."""
    documents = (document.live for document in model.documents.values())
    tasks = (task for facts in documents if facts is not None for task in facts.tasks.values())
    return bool(model.going) or any(task.state not in _STANDING for task in tasks)
