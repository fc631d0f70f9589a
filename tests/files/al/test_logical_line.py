from hypothesis import given, settings, strategies as st

from onika.files.al.logical_line import joined, sentences
from onika.files.text_reading import TextReading
from onika.words.reason import Reason


def content(text: str) -> tuple[list[str], list[str]]:
    """The sentences and the faults of a text."""
    reading = TextReading("f", Reason.plain("nothing"))
    result, _ = sentences(text, reading)
    return [joined(item.tokens) for item in result], [f"{item.place.line}: {item.reason}" for item in reading.faults]


def test_every_line_is_a_sentence_and_comments_and_blank_lines_are_none() -> None:
    assert content("BEGIN { all\nof it }\n\n  NOP   noop{x}\r\nEND") == (["BEGIN", "NOP noop", "END"], [])


def test_within_parentheses_a_sentence_goes_on() -> None:
    assert content("TO x (1\n  2; a=3)\nEND") == (["TO x (1 2; a=3)", "END"], [])


def test_a_word_of_the_language_ends_an_open_parenthesis() -> None:
    assert content("TO x (1\nEND\nTO y (2") == (
        ["TO x (1", "END", "TO y (2"],
        ["1: expected a ) for every (, found 'TO x (1'", "3: expected a ) for every (, found 'TO y (2'"],
    )


def test_a_quoted_text_holds_signs_and_escapes() -> None:
    reading = TextReading("f", Reason.plain("nothing"))
    result, _ = sentences(r'TAG "{a\" \\ (" #2', reading)
    assert [(token.kind, token.value) for token in result[0].tokens] == [
        ("word", "TAG"),
        ("text", '{a" \\ ('),
        ("variant", "#2"),
    ]


def test_what_is_open_at_the_end_of_its_line_or_begins_nothing_is_reported() -> None:
    assert content('A "b\nC }} }\nD\x01 \nE { f') == (
        ["A", "C", "D\x01", "E"],
        [
            "1: expected a \" that ends the text on its line, found '\"b'",
            "2: expected words, numbers, texts in quotes or comments in braces, found '}} }'",
            "3: expected printable text, found 'D\\x01 '",
            "4: expected a } that ends the comment, found '{ f'",
        ],
    )


def test_the_line_where_ends_the_sentences() -> None:
    text = "END\n WHERE \nICON {"
    reading = TextReading("f", Reason.plain("nothing"))
    result, start = sentences(text, reading)
    assert [joined(item.tokens) for item in result] == ["END"]
    assert text[start:] == "ICON {"
    assert reading.end == 1
    assert sentences("WHERE x", reading)[1] == -1


@given(st.text('ab"{}();=# \n\t\\#1', max_size=60))
@settings(deadline=None)
def test_any_text_gives_sentences_on_its_lines(text: str) -> None:
    reading = TextReading("f", Reason.plain("nothing"))
    result, _ = sentences(text, reading)
    for item in result:
        for token in item.tokens:
            assert text.count("\n", 0, token.start) + 1 == token.line
    assert all(1 <= fault.place.line <= text.count("\n") + 1 for fault in reading.faults)
