"""One word for one thing in Spanish too: the table of `docs/words.md` says which, and which never."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TEXTS = (
    *sorted((ROOT / "src" / "onika" / "words" / "text" / "es").glob("*.toml")),
    *sorted((ROOT / "browser" / "src" / "texts").glob("es*.ts")),
)


def terms():
    """The rows of the table: the term, and what is never said for it."""
    _, _, chapter = (ROOT / "docs" / "words.md").read_text(encoding="utf-8").partition("## In Spanish")
    rows = [line.strip("|").split("|") for line in chapter.splitlines() if line.startswith("| ")]
    return [(term.strip(), word.strip()) for _, term, words in rows[1:] for word in words.split(",") if word.strip()]


def places_of(word):
    pattern = re.compile(rf"\b{re.escape(word)}(s|es)?\b", re.IGNORECASE)
    for path in TEXTS:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if pattern.search(line):
                yield f"{path.name}:{number}"


@pytest.mark.parametrize(("term", "word"), terms())
def test_a_thing_has_one_word(term, word):  # R-G03
    assert list(places_of(word)) == [], f"say {term}"
    assert list(places_of(term)), f"{term} is said nowhere"
