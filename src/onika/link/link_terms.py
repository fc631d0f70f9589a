"""The terms of a link: how often it beats, what silence means, how much may be under way."""

from dataclasses import dataclass

_MS = 1_000_000
_MB = 1024 * 1024


@dataclass(frozen=True, slots=True)
class LinkTerms:
    """Times in ns (0: never), amounts in pieces or bytes. The two ends need not have the same."""

    beat_ns: int = 250 * _MS
    suspect_ns: int = 1000 * _MS
    lost_ns: int = 3000 * _MS
    greeting_ns: int = 5000 * _MS
    """How long a greeting may take."""
    retry_ns: int = 0
    """When to say again what was not answered; 0 where a carrier loses nothing while it lives (stream sockets)."""
    window: int = 256
    """Signals under way that are not acknowledged yet."""
    piece: int = 64 * 1024
    """Bytes of a body that go in one packet; a longer one is split, so that signals pass it by."""
    body_limit: int = 64 * _MB
    """Bytes of the longest body of a request or reply."""
    single: int = 512 * 1024
    """Bytes of the longest signal or reading, which are never split."""
    unsettled: int = 1024
    """Requests of one client under way or answered, but not settled by it."""
    reading_age_ns: int = 500 * _MS
    """A reading that could not be sent for so long is dropped."""


LOCAL = LinkTerms()
"""Environment and runtime on one machine or a quiet network."""

CHILD = LinkTerms(suspect_ns=2000 * _MS, lost_ns=30_000 * _MS, greeting_ns=60_000 * _MS, body_limit=512 * _MB)
"""A runtime as a child process: its death closes the connection, so silence means a pause; it starts slowly.

Nobody else speaks to it there, and a plan is as large as the meshes of its worlds.
"""

REMOTE = LinkTerms(beat_ns=100 * _MS, lost_ns=5000 * _MS, greeting_ns=10_000 * _MS)
"""The environment's terms over a network: a runtime that is busy with a plan may be silent for some seconds.

It beats ten times a second, for who holds something is there as long as he is heard.
"""

NO_BEATS = LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0, greeting_ns=60_000 * _MS, reading_age_ns=0)
"""Virtual time: nobody is ever late; only a closed connection ends the link."""
