"""Who is told what happens on the RTPUs: the same in wall and in virtual time."""

from typing import Protocol

from onika.runtime import news
from onika.words.reason import Reason


class UnitListener(Protocol):
    """Hears news of RTPUs and lets time pass; it waits for nothing."""

    @property
    def is_moving(self) -> bool:
        """In virtual time: whether the clock goes on; it stands still while somebody outside is awaited (law 15)."""
        ...

    @property
    def is_still(self) -> bool:
        """Whether scaled time stands still: nothing lives, or an application's task waits for user input."""
        ...

    @property
    def is_hurried(self) -> bool:
        """Whether scaled time goes as fast as it can: what is repeated was looked at when it happened."""
        ...

    def run_began(self, device: str) -> int:
        """When the run began that uses a device, in ns of the runtime's time; 0 where none does."""
        ...

    def hear(self, rtpu: str, message: news.News, now: int) -> None:
        """Take in one piece of news."""
        ...

    def lost(self, rtpu: str, reason: Reason, now: int) -> None:
        """A process is gone, a unit with its tasks or the device server (rtpu empty)."""
        ...

    def wake_at(self) -> int | None:
        """When `tick` has something to do, in ns of the runtime's time."""
        ...

    def tick(self, now: int) -> None:
        """Let time pass."""
        ...
