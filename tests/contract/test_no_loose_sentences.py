"""What people read in a terminal stands in the catalogues: the rooms that print hold no sentence of their own."""

import ast
import re
from pathlib import Path

import pytest

SOURCES = Path(__file__).parents[2] / "src" / "onika"
ROOMS = ("cli", "desk/console", "desk/plan", "desk/run", "desk/trial", "testing", "web")

PROSE = re.compile(r"[a-z]{2,},? [a-z]{2,}")
NO_SENTENCES = re.compile(
    r"(bold|bright) \w+\Z"  # a style of Rich
    r"|[a-z]+ [A-Z]{2,}"  # how a command is written
    r"|import os; "  # a program
    r"|public, max-age"  # a header of HTTP
    r"|branch at line "  # part of a plan, whose digest stands in files
    r"|; it printed last: "  # in recordings of an earlier version
    r"|(cut to start|delete or end)\Z"  # names of keys
    r"|application begin\Z"  # a tag
    r"|pad free\Z"  # a line of a script
)
TEMPLATES = {
    *("desk/plan/module_template.py", "desk/plan/guest_template.py"),
    *("web/access/sign_in_page.py", "web/access/form_page.py"),
}
"""Files that are written as they are here: code for an author, who goes on with it, and HTML, whose words are keys."""


def docstrings(tree):
    """Constants that stand alone: what is said of the code, not by it."""
    return {
        id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }


def loose(source):
    """The sentences in a source that are no docstrings, with their lines."""
    tree = ast.parse(source)
    excused = docstrings(tree)
    for node in ast.walk(tree):
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in excused
        if is_text and PROSE.search(node.value) and not NO_SENTENCES.match(node.value):
            yield node.lineno, node.value


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_that_prints_holds_no_sentence(room):  # R-G03
    files = [path for path in sorted((SOURCES / room).rglob("*.py")) if "static" not in path.parts]
    names = {path: path.relative_to(SOURCES).as_posix() for path in files}
    sentences = {
        f"{name}:{line}": text
        for path, name in names.items()
        if name not in TEMPLATES
        for line, text in loose(path.read_text(encoding="utf-8"))
    }
    assert sentences == {}
    assert files


def test_a_sentence_would_be_seen():
    source = '"""A module that is told of."""\n\nprint("nothing is done")\nprint(f"{1} is not there")\n'
    assert list(loose(source)) == [(3, "nothing is done"), (4, " is not there")]
