"""A question to whoever sits at the terminal, answered by a letter."""

from onika.cli.language import say
from onika.words.reason import Reason


def agrees(question: Reason) -> bool:
    """Whether somebody at the terminal says yes; in any language `y` will do, and the word's first letter there."""
    answer = input(say(question) + " ").strip().casefold()
    return answer[:1] in ("y", "s")
