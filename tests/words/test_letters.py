"""Texts and characters in memory."""

import pytest
from hypothesis import given, strategies as st

from onika.words import letters
from onika.words.value import TEXT_CAPACITY, ValueType

WORDS = st.text(st.characters(exclude_characters="\0", exclude_categories=("Cs",)), max_size=60)


@given(WORDS)
def test_a_text_comes_back_from_memory(text):  # law 7
    data = letters.encode(text, ValueType.STRING, TEXT_CAPACITY)
    assert len(data) == TEXT_CAPACITY
    assert letters.decode(data, ValueType.STRING, False) == text


@given(st.lists(WORDS, min_size=1, max_size=4))
def test_several_texts_come_back_as_a_list(texts):  # R-A03
    data = letters.encode(texts, ValueType.LINE, TEXT_CAPACITY * len(texts))
    assert letters.decode(data, ValueType.LINE, True) == texts


@given(st.text(st.characters(max_codepoint=255), min_size=1, max_size=8))
def test_characters_are_one_byte_each(text):
    data = letters.encode(text, ValueType.CHAR, len(text))
    assert len(data) == len(text)
    assert letters.decode(data, ValueType.CHAR, True) == list(text)
    assert letters.decode(data[:1], ValueType.CHAR, False) == text[0]


def test_a_text_that_is_too_long_is_refused_and_one_that_just_fits_is_not():
    just = "x" * (TEXT_CAPACITY - 1)
    assert letters.decode(letters.encode(just, ValueType.STRING, TEXT_CAPACITY), ValueType.STRING, False) == just
    with pytest.raises(ValueError, match=f"at most {TEXT_CAPACITY - 1} bytes of text, found {TEXT_CAPACITY}"):
        letters.encode("x" * TEXT_CAPACITY, ValueType.STRING, TEXT_CAPACITY)


def test_the_number_of_texts_is_that_of_the_places():
    with pytest.raises(ValueError, match="expected 2 of type string, found 1"):
        letters.encode("one", ValueType.STRING, 2 * TEXT_CAPACITY)
    with pytest.raises(ValueError, match="expected 1 of type char, found 2"):
        letters.encode("ab", ValueType.CHAR, 1)


@pytest.mark.parametrize(("kind", "value"), [(ValueType.CHAR, "€"), (ValueType.STRING, [5])])
def test_what_is_no_text_or_character_is_refused(kind, value):
    with pytest.raises(ValueError, match=f"expected a value of type {kind.value}"):
        letters.encode(value, kind, kind.size)


def test_bytes_that_are_no_text_are_replaced_and_never_raise():
    data = b"\xff\xfe".ljust(TEXT_CAPACITY, b"\0")
    assert letters.decode(data, ValueType.STRING, False) == "\ufffd\ufffd"
