"""The heartbeat of a process: when it was last alive and whose code it runs, in shared memory (law 30)."""

from time import monotonic_ns

from onika.ring.begin_words import SIZE as BEGIN_WORDS, BeginWords
from onika.ring.last_words import LastWords
from onika.ring.segment import Segment
from onika.words.reason import Reason

SIZE = 4096
_LAST_WORDS_AT = 64
_BEGIN_WORDS_AT = SIZE - BEGIN_WORDS


class Heartbeat:
    """Written by the process itself, read by the supervisor; three words and its last words."""

    def __init__(self, segment: Segment) -> None:
        self._words = segment.view[:32].cast("Q")
        self._last_words = LastWords(segment.view[_LAST_WORDS_AT:])
        self.begin_words = BeginWords(segment.view[_BEGIN_WORDS_AT:])
        """By which the runtime lets what it has appointed begin (law 34)."""
        self.watch = self._last_words.watch
        """Is told whose code runs from now on; "" for the executive's own."""

    def beat(self) -> None:
        """Alive now."""
        self._words[0] = monotonic_ns()

    def is_slow(self, slow: bool) -> None:
        """Announce work that may take long (loading, initialising), or its end."""
        self._words[1] = slow

    def look(self) -> None:
        """The process has looked at its own code just now, and it is what it was."""
        self._words[2] = monotonic_ns()

    def leave(self, reason: Reason) -> None:
        """Why the process is about to end itself."""
        self._last_words.leave(reason)

    @property
    def last_ns(self) -> int:
        """When it was last alive (monotonic clock), 0 before the first beat."""
        return self._words[0]

    @property
    def takes_long(self) -> bool:
        """Whether it has announced long work."""
        return bool(self._words[1])

    @property
    def looked_ns(self) -> int:
        """When it last looked at its own code, 0 where it does not do so."""
        return self._words[2]

    @property
    def task(self) -> str:
        """Whose code runs."""
        return self._last_words.task

    @property
    def reason(self) -> Reason:
        """Why it has ended itself, if it has."""
        return self._last_words.reason
