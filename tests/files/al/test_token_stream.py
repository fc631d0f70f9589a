from collections.abc import Callable

import pytest

from onika.files.al.logical_line import sentences
from onika.files.al.token import KEYWORDS
from onika.files.al.token_stream import TokenStream
from onika.files.text_reading import TextReading
from onika.words.reason import Reason


def phrase(text: str, at: int = 0) -> TokenStream:
    (sentence,), _ = sentences(text, TextReading("f", Reason.plain("nothing")))
    return TokenStream(sentence, at)


def test_words_are_read_from_left_to_right() -> None:
    item = phrase("DRIVE jmoveC #2 TO")
    assert item.takes("MOVE", "DRIVE") == "DRIVE"
    assert item.takes("DRIVE") == ""
    assert item.name(Reason.plain("a name"), KEYWORDS) == "jmoveC"
    assert (item.variant(), item.variant(), item.variant(default=0)) == (2, 1, 0)
    assert not item.is_over
    assert item.rest() == "'TO'"
    assert item.takes("TO")
    assert item.is_over
    item.end()


def test_a_name_that_is_a_word_of_the_language_stands_in_quotes() -> None:
    assert phrase('"TO"').name(Reason.plain("a name"), KEYWORDS) == "TO"
    with pytest.raises(ValueError, match="expected a name, found 'TO'"):
        phrase("TO").name(Reason.plain("a name"), KEYWORDS)


@pytest.mark.parametrize(
    ("text", "end", "result"),
    [
        ("LAMP  ==  1", "", "LAMP == 1"),
        ("flow0/Q_MEZ[2,3]>=-1.5e3", "", "flow0/Q_MEZ[2,3]>=-1.5e3"),
        ("THEN != 1 THEN", "THEN", "THEN != 1"),
        ('"LAMP  == 1" THEN', "THEN", "LAMP  == 1"),
    ],
)
def test_a_condition_is_the_rest_of_a_sentence(text: str, end: str, result: str) -> None:
    assert phrase(text).condition(end) == result  # R-D13


READS: list[tuple[str, Callable[[TokenStream], object], str]] = [
    ("DO", lambda item: item.end(), "expected the end of the line, found 'DO'"),
    ("DO", lambda item: phrase("DO", 1).tag(), "expected a tag of one word, found the end of the line"),
    ('"a b"', lambda item: item.tag(), "expected a tag of one word, found 'a b'"),
    ("2x", lambda item: item.name(Reason.plain("a name"), KEYWORDS), "expected a name, found '2x'"),
    ("LAMP", lambda item: item.condition(), "expected an address, a comparison"),
    ("LAMP == 1", lambda item: item.condition("THEN"), "expected THEN behind the condition, found 'LAMP == 1'"),
]


@pytest.mark.parametrize(("text", "read", "complaint"), READS)
def test_what_does_not_fit_is_told_as_expected_and_found(
    text: str, read: Callable[[TokenStream], object], complaint: str
) -> None:
    with pytest.raises(ValueError, match=complaint.replace("(", r"\(")):
        read(phrase(text))
