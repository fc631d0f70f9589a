"""Strokes of a pad in a script: pushes are believed for a moment only, so a stroke is many of them (K07)."""

from math import ceil

PERIOD_S = 0.05
"""Between two pushes of a stroke."""
_LONGEST_S = 600.0


def steps(line: str) -> tuple[str, ...]:
    """What a line means push by push: `pad 0 0 -1 for 2` is a stroke of two seconds, any other line itself.

    Before a stroke the pad is let go, as its dead-man wants it, and behind it, too; a press of the button may be the
    end of what listens, and lets go by itself. A time that is none is left where it stands: who reads the line says so.
    """
    words = line.split()
    if len(words) < 3 or words[0] != "pad" or words[-2] != "for":
        return (line,)
    try:
        seconds = float(words[-1])
    except ValueError:
        return (line,)
    if not 0.0 < seconds <= _LONGEST_S:
        return (line,)
    push, pause = " ".join(words[:-2]), f"wait {PERIOD_S}"
    count = ceil(round(seconds / PERIOD_S, 6))
    if words[1] == "press":
        return (push, pause) * count
    return ("pad free", pause, *(push, pause) * count, "pad free")
