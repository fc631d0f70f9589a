"""The rest of a runtime that was launched here: the system holds it while nobody has to do with it (X25)."""

from typing import Protocol, runtime_checkable


@runtime_checkable
class RestingRuntime(Protocol):
    """A runtime that may be able to rest."""

    def rest(self) -> bool:
        """Have it held; whether it is."""
        ...

    def wake(self) -> None:
        """Have it go on where it was."""
        ...


class RuntimeRest:
    """Whether a runtime is to rest, and whether it does."""

    def __init__(self) -> None:
        self.is_wished = False
        self.goes_on = False

    def lie_down(self, runtime: object, is_busy: bool) -> None:
        """Let it rest, where that is wished and nobody waits for it."""
        if self.is_wished and not self.goes_on and not is_busy and isinstance(runtime, RestingRuntime):
            self.goes_on = runtime.rest()

    def end(self, runtime: object) -> None:
        """Whatever comes, it hears it."""
        if self.goes_on and isinstance(runtime, RestingRuntime):
            runtime.wake()
        self.goes_on = False
