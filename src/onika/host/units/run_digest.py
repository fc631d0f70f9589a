"""The digest of a virtual run: the worlds every 50 ms and every word to the runner, as one number (laws 14, 15)."""

import hashlib
from collections.abc import Iterable

from onika.runtime import news
from onika.runtime.bus import World

_LOOKED_EVERY_NS = 50_000_000  # what differs once differs ever after: to look at every step would only cost


class Digest:
    """Equal for equal runs, and hardly ever for others."""

    def __init__(self, now: int = 0) -> None:
        self._hash = hashlib.sha256()
        self.look_at = now
        """When it is time to look at the worlds."""
        self.outside: set[str] = set()
        """The tasks that had to do with the outside: with them no run repeats."""

    def look(self, now: int, worlds: Iterable[World]) -> None:
        """Take in the worlds as they stand, if it is time."""
        if now >= self.look_at:
            self.look_at = now + _LOOKED_EVERY_NS
            for world in worlds:
                self._hash.update(world.fingerprint())

    def hear(self, word: news.News) -> None:
        """Take in what the runner is told."""
        self._hash.update(news.encode(news.in_english(word)))

    def hexdigest(self) -> str:
        """Of everything that was taken in."""
        return self._hash.hexdigest()
