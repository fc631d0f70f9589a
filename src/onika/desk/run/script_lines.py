"""Reads a script: the lines of a file with their places, comments left out (requirement A16)."""

from collections.abc import Iterator
from pathlib import Path

from onika.files import text
from onika.words.fault import Fault, Place


def load(path: Path) -> tuple[list[tuple[Place, str]] | None, tuple[Fault, ...]]:
    """The lines of a script with their places; None with the faults where it cannot be read."""
    content, faults = text.load(path, str(path))
    if content is None:
        return (None, faults)
    return (list(lines(content, str(path))), faults)


def lines(content: str, name: str) -> Iterator[tuple[Place, str]]:
    """The lines that say something, with their places."""
    for number, line in enumerate(content.splitlines(), 1):
        command = bare(line)
        if command:
            yield Place(name, number), command


def bare(line: str) -> str:
    """A line without its comment; a `#` within double quotes or within a word begins none."""
    quoted = False
    for index, letter in enumerate(line):
        if letter == '"' and line[index - 1 : index] != "\\":
            quoted = not quoted
        elif letter == "#" and not quoted and (index == 0 or line[index - 1].isspace()):
            return line[:index].strip()
    return line.strip()
