"""The start of a runtime, in the place of the class: nothing comes up, and it is remembered what was asked for."""

from types import TracebackType
from typing import ClassVar


class IdleStart:
    """Nobody takes it: the test has a runtime already, or needs none."""

    begun: ClassVar[list["IdleStart"]] = []

    def __init__(self, arguments: list[str], **options: bool) -> None:
        self.arguments = arguments
        self.options = options
        self.is_closed = False
        self.begun.append(self)

    def __enter__(self) -> "IdleStart":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.is_closed = True
