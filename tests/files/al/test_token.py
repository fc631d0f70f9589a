import pytest
from hypothesis import given, strategies as st

from onika.files.al.token import KEYWORDS, is_label, quoted, show, unquoted


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("home", "home"),
        ("box2_aj", "box2_aj"),
        ("TO", '"TO"'),
        ("to", "to"),
        ("", '""'),
        ("a b", '"a b"'),
        ("#1", '"#1"'),
    ],
)
def test_a_word_stands_bare_where_it_cannot_be_mistaken(text: str, shown: str) -> None:
    assert show(text) == shown


@given(st.text(st.characters(exclude_categories=("Cc", "Cs"))))
def test_what_is_quoted_is_read_again(text: str) -> None:
    assert unquoted(quoted(text)) == text


def test_every_word_of_the_language_is_quoted_as_a_name_and_is_no_label() -> None:
    assert not any(show(item) == item or is_label(item) for item in KEYWORDS)
    assert is_label("duration")
    assert not is_label("two words")
