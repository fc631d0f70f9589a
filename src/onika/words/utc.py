"""A time of day as it is written where nobody's own time zone is known."""

from datetime import UTC, datetime


def utc(at_s: float) -> str:
    """Seconds of UTC since 1970, to the minute: `2026-11-24 12:00 UTC`."""
    return datetime.fromtimestamp(at_s, UTC).strftime("%Y-%m-%d %H:%M UTC")
