"""Text from elsewhere made safe for a terminal: without control sequences."""


def safe(text: str) -> str:
    """The same text, with a sign of its own in place of each that cannot be printed; its lines stay lines."""
    return "\n".join(_line(line) for line in text.splitlines())


def _line(text: str) -> str:
    plain = text.expandtabs(4)
    if plain.isprintable():
        return plain
    return "".join(letter if letter.isprintable() else "�" for letter in plain)
