"""Turns what is wrong with a steering line into a fault at its place."""

from onika.words.fault import Fault, Place

GOES_ON = "the run goes on as it was"


def objection(place: Place, text: str, instead: str) -> Fault:
    """The fault of a text `expected …, found …`; of any other, that it was not done for this reason."""
    if not text.startswith("expected "):
        return Fault(place, "a line that can be carried out", text, instead)
    expected, _, actual = text.removeprefix("expected ").partition(", found ")
    return Fault(place, expected, actual or "it is not so", instead)
