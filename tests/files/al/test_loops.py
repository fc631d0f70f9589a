from hypothesis import given, strategies as st

from onika.files.al.loops import LoopBlock, loops
from onika.model.application import Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank


def heads(text: str) -> list[Icon | None]:
    """Icons by their tags: `a` an anchor, `A` a test, `.` none, `_` a statement without an icon."""
    onikon = Onikon("x", "Complete job", "", (), blank())
    made = {".": Icon(onikon), "_": None}
    return [made.get(item, Icon(onikon, while_tag=item.lower(), while_test=item.isupper())) for item in text]


def result(text: str) -> list[str]:
    return [
        f"{'top' if loop.tests_first else 'bottom'} {loop.tag} {loop.first} {loop.last}" for loop in loops(heads(text))
    ]


def test_the_test_stands_first_or_last() -> None:
    assert result("a._A") == ["bottom a 0 3"]  # R-E05
    assert result("A.a") == ["top a 0 2"]


def test_loops_stand_apart_or_within_each_other() -> None:
    assert result("abBcCA") == ["bottom a 0 5", "bottom b 1 2", "bottom c 3 4"]


def test_of_crossing_loops_one_is_shown_as_a_block() -> None:
    assert result("abAB") == ["bottom b 1 3"]  # reading 23


def test_lonely_tags_several_tests_and_conditions_at_the_anchor_are_no_loops() -> None:
    assert result("a") == result("aa") == result("AA") == result("aAa") == []
    icons = heads("aA")
    assert icons[0] and icons[1]
    odd = Icon(icons[0].onikon, while_tag="a", while_if="LAMP == 1")
    assert loops([odd, icons[1]]) == ()


def test_the_condition_is_that_of_the_test() -> None:
    (anchor,) = heads("a")
    assert anchor
    test = Icon(anchor.onikon, while_tag="a", while_test=True, while_if="LAMP == 1")
    assert loops([test, anchor]) == (LoopBlock("a", 0, 1, True, "LAMP == 1"),)


@given(st.text("aAbBcC.", max_size=12))
def test_what_is_found_never_crosses(text: str) -> None:
    spans = [(loop.first, loop.last) for loop in loops(heads(text))]
    for first, last in spans:
        assert text[first].lower() == text[last].lower()
        for start, end in spans:
            assert not first < start < last < end
