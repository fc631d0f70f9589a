"""What people call a thing of a world, in each language: lines `NAME en the box with the waves` (requirement X19)."""

from onika.files.block_words import BlockWords
from onika.files.line import one_line, row
from onika.files.text_reading import KeywordSlot, Need
from onika.model.world import Names
from onika.words.reason import Reason
from onika.words.sentence import LANGUAGES

NAME, HAND_NAME = "NAME", "HANDNAME"


def slot(keyword: str = NAME) -> KeywordSlot:
    """Where the lines stand in a block."""
    return KeywordSlot(keyword, Need.OPTIONAL, many=True)


def read_names(words: BlockWords, keyword: str = NAME) -> Names:
    """The names of a block; a line that says no language, or one that was there, is told."""
    names: dict[str, str] = {}
    for line in words.rows(keyword):
        language, _, text = line.text.partition(" ")
        if language not in LANGUAGES or not text or language in names:
            words.wrong_row(line, Reason.of("files.language_and_name", languages=LANGUAGES))
        else:
            names[language] = text
    return tuple(names.items())


def show_names(names: Names, keyword: str = NAME) -> str:
    """The lines of these names."""
    return "".join(row(keyword, language, one_line(text)) for language, text in names)
