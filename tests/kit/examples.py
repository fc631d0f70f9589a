"""On how many examples a property is tried: as the profile has it, of which 100 is the whole."""

from hypothesis import settings

_WHOLE = 100


def examples(count: int) -> int:
    """So many where the profile asks for the whole, else their share."""
    return max(1, round(count * settings().max_examples / _WHOLE))
