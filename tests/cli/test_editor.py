import pytest
from hypothesis import given, strategies as st

from onika.cli.editor import Editor


def typed(*keys, complete=lambda before: [], history=()):
    """An editor after these keys; a key of several letters in brackets, all else letter by letter."""
    one = Editor(complete, list(history))
    for key in keys:
        for part in [key[1:-1]] if key.startswith("<") else key:
            one.press(part)
    return one


@pytest.mark.parametrize(
    ("keys", "text", "cursor"),
    [
        (("spawn", "<left>", "<left>", "X"), "spaXwn", 4),
        (("abc", "<home>", "<right>", "<delete>"), "ac", 1),
        (("abc", "<backspace>"), "ab", 2),
        (("<backspace>", "<left>", "a"), "a", 1),
        (("on puma 1", "<word left>", "<word left>"), "on puma 1", 3),
        (("on puma", "<home>", "<word right>", "<word right>"), "on puma", 7),
        (("on puma ", "<cut word>"), "on ", 3),
        (("on puma", "<home>", "<cut word right>"), " puma", 0),
        (("on puma", "<left>", "<left>", "<cut to end>"), "on pu", 5),
        (("on puma", "<left>", "<cut to start>"), "a", 0),
        (("ab cd", "<cut word>", "<home>", "<paste>"), "cdab ", 2),
        (("ab", "<delete or end>"), "ab", 2),
        (("ab", "<unknown key>"), "ab", 2),
    ],
)
def test_a_line_is_edited(keys, text, cursor):
    one = typed(*keys)
    assert (one.text, one.cursor) == (text, cursor)


def test_enter_gives_the_line_and_begins_a_new_one():
    one = typed("status")
    assert one.press("enter") == "status"
    assert (one.text, one.history) == ("", ["status"])
    assert typed("").press("enter") == ""


def test_the_end_of_the_input_is_typed_into_an_empty_line_only():
    assert not typed("a", "<delete or end>").is_over
    assert typed("<delete or end>").is_over


@pytest.mark.parametrize(
    ("keys", "text"),
    [
        (("<up>",), "off"),
        (("<up>", "<up>"), "on puma"),
        (("on", "<up>"), "on puma"),
        (("on", "<up>", "<up>"), "on diff"),
        (("on", "<up>", "<down>"), "on"),
        (("<up>", "<up>", "<up>", "<up>"), "on diff"),
        (("<down>",), ""),
        (("x", "<up>"), "x"),
        (("<up>", "!", "<up>"), "off!"),
    ],
)
def test_earlier_lines_that_begin_so_are_found(keys, text):  # R-A16
    assert typed(*keys, history=("on diff", "on puma", "off")).text == text


def test_a_line_said_twice_in_a_row_is_kept_once_and_blank_ones_never():
    one = Editor(lambda before: [])
    for line in ("a", "a", " ", "b", "a"):
        for letter in line:
            one.press(letter)
        one.press("enter")
    assert one.history == ["a", "b", "a"]


@pytest.mark.parametrize(
    ("text", "candidates", "after", "offered"),
    [
        ("sp", ["spawn"], "spawn ", []),
        ("s", ["spawn", "spare"], "spa", []),
        ("spa", ["spawn", "spare"], "spa", ["spawn", "spare"]),
        ("source scr", ["scripts/"], "source scripts/", []),
        ("on ", ["puma"], "on puma ", []),
        ("x", [], "x", []),
    ],
)
def test_tab_completes_as_far_as_it_can_and_then_offers(text, candidates, after, offered):  # R-A16
    one = typed(text, "<tab>", complete=lambda before: candidates if before == text else pytest.fail(before))
    assert (one.text, one.offered) == (after, offered)


def test_only_what_stands_before_the_cursor_is_completed():
    one = typed("spx", "<left>", "<tab>", complete=lambda before: ["spawn"] if before == "sp" else [])
    assert one.text == "spawn x"


KEYS = [
    "a", " ", "left", "right", "home", "end", "up", "down", "tab", "enter", "backspace", "delete", "cut word",
    "cut to end", "cut to start", "paste", "word left", "word right", "cut word right", "delete or end",
]  # fmt: skip


@given(st.lists(st.sampled_from(KEYS)))
def test_the_cursor_stays_in_the_line_whatever_is_pressed(keys):
    one = Editor(lambda before: ["aa", "ab"], ["a b", "b"])
    for key in keys:
        one.press(key)
        assert 0 <= one.cursor <= len(one.text)
