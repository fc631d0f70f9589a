"""A question to whoever sits at the terminal, answered by a letter."""


def agrees(question: str) -> bool:
    """Whether somebody at the terminal says yes; in any language `y` will do, and the word's first letter there."""
    answer = input(f"{question} ").strip().casefold()
    return answer[:1] in ("y", "s")
