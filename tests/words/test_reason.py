"""A reason travels as key and arguments, and is said in the language of who reads it."""

import msgspec
import pytest

from onika.words.reason import NOTHING, Reason, in_language

OPTION = Reason.of("cli.language_option", languages=("en", "es"), default="en")


def test_a_reason_is_made_with_its_english_sentence():
    assert str(OPTION) == OPTION.text
    assert OPTION.text.startswith("the language of what is said, en or es; en where")
    assert OPTION.key == "cli.language_option"
    assert OPTION.args == {"languages": ("en", "es"), "default": "en"}


def test_a_reason_is_said_in_spanish():
    assert in_language(OPTION, "es").startswith("el idioma de los mensajes, en o es; en si")
    assert in_language(OPTION, "en") == OPTION.text


def test_a_reason_within_a_reason_is_said_in_the_same_language():
    outer = Reason.of("cli.language_option", languages=(OPTION, "x"), default=OPTION)
    assert OPTION.text in outer.text
    assert in_language(outer, "es").count(in_language(OPTION, "es")) == 2
    assert OPTION.text not in in_language(outer, "es")


def test_a_text_of_others_is_shown_as_it_is():
    assert (
        in_language(Reason.plain("no such file"), "es")
        == "no such file"
        == in_language(Reason.plain("no such file"), "es")
    )


@pytest.mark.parametrize(
    "stranger",
    [
        Reason("cli.of_a_newer_version", "it is so"),
        Reason(OPTION.key, "it is so"),
        Reason(OPTION.key, "it is so", {"languages": "a", "default": "b", "more": 3}),
    ],
)
def test_a_reason_of_a_peer_is_shown_by_its_text_where_its_sentence_is_not_ours(stranger):
    assert in_language(stranger, "es") in (
        "it is so",
        "el idioma de los mensajes, a; b si ni esto ni ONIKA_LANG indican otro",
    )


def test_there_is_something_said_or_nothing():
    assert OPTION and Reason.plain("x") and not NOTHING and not Reason.plain("") and Reason.plain("") == NOTHING


def test_reasons_are_ordered_by_what_they_say_and_may_be_keys():
    first, second = Reason.plain("a"), Reason.plain("b")
    assert sorted([second, first]) == [first, second]
    assert list({OPTION: 1, Reason.of(OPTION.key, **OPTION.args): 2}.values()) == [2]


@pytest.mark.parametrize("reason", [OPTION, NOTHING, Reason.of(OPTION.key, languages=(OPTION,), default=2.5)])
def test_a_reason_travels(reason):
    for coder in (msgspec.json, msgspec.msgpack):
        assert coder.decode(coder.encode(reason), type=Reason) == reason


def test_a_key_that_nobody_wrote_is_the_programmers_error():
    with pytest.raises(KeyError):
        Reason.of("cli.there_is_no_such")
    with pytest.raises(KeyError, match="default"):
        Reason.of("cli.language_option", languages=())
