"""What does not stand where it stood at the start of its world (law 18)."""

from msgspec import Struct

from onika.words.reason import Reason


class Displacement(Struct, frozen=True):
    """One thing that is elsewhere, in words."""

    text: Reason
    is_harmless: bool = False
    """Whether a program can begin from there all the same: an arm moves from wherever it stands, a box does not."""
