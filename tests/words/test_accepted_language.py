import pytest
from hypothesis import given, strategies as st

from onika.words.accepted_language import accepted_language
from onika.words.sentence import LANGUAGES


@pytest.mark.parametrize(
    ("header", "language"),
    [
        ("", "en"),
        ("es", "es"),
        ("ES-mx", "es"),
        ("fr, es;q=0.5, en;q=0.2", "es"),
        ("fr, en;q=0.2, es;q=0.5", "es"),
        ("es, en", "es"),
        ("es-MX;q=0.9, es;q=0.1, en;q=0.5", "es"),
        ("es;q=0", "en"),
        ("es;q=0, en;q=0", "en"),
        ("es;q=nan", "en"),
        ("es;q=2", "en"),
        ("es;level=1", "en"),
        ("es; q = 0.5", "es"),
        ("*", "en"),
        ("estonian", "en"),
    ],
)
def test_the_language_that_is_wanted_most_and_is_ours_is_spoken(header, language):  # R-G03
    assert accepted_language(header) == language


@given(st.text())
def test_whatever_is_sent_a_language_of_ours_is_spoken(header):  # R-F01
    assert accepted_language(header) in LANGUAGES
