import pytest

from onika.desk.console.command import Command, find
from onika.words.reason import Reason


def command(name, **given):
    return Command(name, f"{name} …", Reason.plain("what it does"), lambda session, words: (), **given)


def test_a_unique_beginning_names_a_command_and_a_whole_name_always_does():  # R-A16
    on, open_, off = command("on"), command("open"), command("off")
    every = (on, open_, off)
    assert find("on", every) == [on]
    assert find("op", every) == [open_]
    assert find("o", every) == [on, open_, off]
    assert find("x", every) == find("", every) == []


@pytest.mark.parametrize(
    ("given", "rest", "words"),
    [
        ({}, 'a "b c"', ("a", "b c")),
        ({"raw": 0}, 'a  "b', ('a  "b',)),
        ({"raw": 1}, "jtraj  1  2 ", ("jtraj", "1  2")),
        ({"raw": 2}, "jtraj label two words", ("jtraj", "label", "two words")),
        ({"raw": 1}, "", ()),
    ],
)
def test_words_are_taken_as_the_command_takes_them(given, rest, words):
    assert command("x", **given).words(rest) == words


@pytest.mark.parametrize(("given", "rest"), [({"least": 1}, ""), ({"most": 1}, "a b"), ({}, 'a "b')])
def test_too_few_too_many_and_open_quotes_are_told(given, rest):
    with pytest.raises(ValueError, match=r"x|quotes"):
        command("x", **given).words(rest)
