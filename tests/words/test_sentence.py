"""Sentences are filled by the same rules here and in the page: both run through `sentences.json`."""

import json
from pathlib import Path

import pytest

from onika.words.sentence import LANGUAGES, fill, gaps

CASES = json.loads(Path(__file__).with_name("sentences.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case['sentence']} {case['args']}")
def test_a_sentence_is_filled(case, language):
    assert fill(case["sentence"], case["args"], language) == case[language]


def test_the_gaps_of_a_sentence_are_its_arguments():
    assert gaps("{a}, {b:quoted}, {a:plural:x|y}, {{c}}") == {"a", "b"}


def test_what_is_no_text_number_or_list_is_shown_by_the_caller():
    assert (
        fill("{a} and {names}", {"a": None, "names": (None,)}, "en", lambda value: "nothing") == "nothing and nothing"
    )


def test_a_missing_argument_is_the_programmers_error():
    with pytest.raises(KeyError, match="a"):
        fill("{a}", {}, "en")


@pytest.mark.parametrize(("sentence", "value"), [("{a:.2g}", "text"), ("{a:upper}", "text"), ("{a:x}", 3)])
def test_a_rule_that_does_not_suit_is_the_programmers_error(sentence, value):
    with pytest.raises(ValueError, match="expected a rule"):
        fill(sentence, {"a": value}, "en")
