"""Whose code runs: a sweep notes it at each of its tasks, and who looks whether a call comes back reads it."""

from collections.abc import Callable


class Whereabouts:
    """Called with the task before its code runs, with "" after; who runs several in turn sets the figures itself."""

    __slots__ = ("also", "calls", "memory", "task")

    def __init__(self) -> None:
        self.task = ""
        """Whose code runs; "" for the executive's own."""
        self.calls = 0
        """How often somebody's code began or ended; a sweep counts as one, in which each task runs once."""
        self.also: Callable[[str], None] | None = None
        """Is told too, at each call."""
        self.memory: memoryview | None = None
        """Where whose code runs is noted for who has started this process, as `last_words.name_of` it."""

    def __call__(self, task: str) -> None:
        """Whose code runs from now on."""
        self.task = task
        self.calls += 1
        if self.also is not None:
            self.also(task)
