"""Sentences of modules as reasons."""

import pytest

from onika.words.module_sentence import key_of, of_module, of_sentence
from onika.words.reason import Reason

SENTENCE = "joint {joint} is beyond {limit:.1f}"


def test_a_sentence_with_arguments_is_filled_and_carries_itself_in_its_key():
    reason = of_module(of_sentence(SENTENCE, {"joint": 3, "limit": 2.14, "unused": object()}), "reach")
    assert reason == Reason(f"module:reach:{SENTENCE}", "joint 3 is beyond 2.1", {"joint": 3, "limit": 2.14})
    assert reason.key == key_of("reach", SENTENCE)


def test_a_sentence_without_arguments_is_taken_as_it_is():
    assert of_sentence("a {brace} and {{two}}", {}) == Reason("module::a {brace} and {{two}}", "a {brace} and {{two}}")
    assert of_sentence(ValueError("hot"), {}).text == "hot"
    assert not of_sentence("", {})


@pytest.mark.parametrize("sentence", ["{missing}", "{joint:nonsense}"])
def test_a_sentence_that_cannot_be_filled_is_taken_as_it_is(sentence):
    assert of_sentence(sentence, {"joint": 3}).text == sentence


def test_what_cannot_be_sent_is_made_plain():
    reason = of_sentence("{a} {b} {c}", {"a": 1 << 70, "b": [1.5, ValueError("x")], "c": True})
    assert reason.args == {"a": str(1 << 70), "b": (1.5, "x"), "c": True}


def test_a_reason_of_our_own_is_kept_and_reasons_within_it_get_the_name_of_the_module():
    own = Reason.of("runtime.goes_off", why=of_sentence("silent", {}))
    assert of_sentence(own, {}) is own
    assert of_module(own, "lamp").args == {"why": Reason("module:lamp:silent", "silent")}
