"""The descriptor guard: it finds module code that closed its process's way to the runtime, and names it (law 30)."""

import os
from collections.abc import Callable

from onika.host.guards.code_watch import GAVE_UP
from onika.words.reason import Reason


class DescriptorGuard:
    """Is told whose code runs, and looks then what became of a descriptor in the code that ran until now.

    One that is ours is not inheritable; another that was put in its place is, or is none.
    """

    def __init__(
        self,
        descriptor: int,
        note: Callable[[str], None],
        leave: Callable[[Reason], None],
        end: Callable[[int], object] = os._exit,
    ) -> None:
        os.set_inheritable(descriptor, False)
        self._descriptor = descriptor
        self._note = note
        self._leave = leave
        self._end = end
        self._task = ""
        self._look = os.get_inheritable  # kept: it is called before and after each cycle

    def watch(self, task: str) -> None:
        """Whose code runs from now on; "" for the executive's own."""
        try:
            is_ours = not self._look(self._descriptor)
        except OSError:
            is_ours = False
        if not is_ours:
            self._leave(Reason.of("host.descriptor_closed", task=self._task))
            self._end(GAVE_UP)
        self._task = task
        self._note(task)
