import math

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.words.condition import Condition

NAMES = st.from_regex(r"[A-Z][A-Z0-9_^]{0,6}", fullmatch=True)
HOMES = st.from_regex(r"[A-Za-z][A-Za-z0-9_.-]{0,6}", fullmatch=True)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
RELATIONS = {
    "==": lambda item, other: item == other,
    "!=": lambda item, other: item != other,
    "<=": lambda item, other: item <= other,
    ">=": lambda item, other: item >= other,
    "<": lambda item, other: item < other,
    ">": lambda item, other: item > other,
}
BLANKS = st.sampled_from(["", " ", "  ", "\t"])


@settings(deadline=None, max_examples=examples(200))
@given(st.lists(HOMES, max_size=2), NAMES, st.lists(st.integers(0, 99), max_size=2), st.sampled_from(sorted(RELATIONS)),
       NUMBERS, NUMBERS, st.lists(BLANKS, min_size=4, max_size=4))  # fmt: skip
def test_an_expectation_is_an_address_a_comparison_and_a_number(homes, name, index, relation, number, value, blanks):
    item, two, three, four = blanks  # law 8
    where = "/".join([*homes, name]) + (f"[{','.join(map(str, index))}]" if index else "")
    parse = Condition.parse(f"{item}{where}{two}{relation}{three}{number!r}{four}")
    assert parse.address == "/".join([*homes, name][-2:])
    assert (parse.index, parse.relation, parse.number) == (tuple(index), relation, number)
    held = value
    for at in reversed(index):
        held = [None] * at + [held]
    assert parse.value_of({parse.address: held}) == value
    assert parse.holds({parse.address: held}) == RELATIONS[relation](value, number)


@settings(deadline=None, max_examples=examples(300))
@given(st.one_of(st.text(max_size=30), st.text(alphabet="AQ_^[]0123456789.+-e=<>!/ ()'\n", max_size=20)))
def test_any_other_text_is_refused_with_what_was_expected(text):  # law 8
    try:
        parse = Condition.parse(text)
    except ValueError as wrong:
        assert "expected an address, a comparison and a number" in str(wrong)
    else:
        assert math.isfinite(parse.number) or "e" in text
        assert any(relation in text for relation in RELATIONS)


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('true') == 0",
        "LAMP == open('/etc/passwd')",
        "LAMP == 1 or 1",
        "LAMP == 1; LAMP",
        "LAMP.__class__ == 1",
        "LAMP[-1] == 1",
        "LAMP[0] [1] == 1",
        "lamp == 1",
        "LAMP = 1",
        "LAMP === 1",
        "LAMP == nan",
        "LAMP == inf",
        "LAMP == 0x10",
        "LAMP == 1\n== 1",
        "LAMP == LAMP",
        "a/b/c/LAMP == 1",
        "== 1",
        "",
    ],
)
def test_nothing_is_ever_evaluated_as_code(text):  # law 8
    with pytest.raises(ValueError, match="expected an address, a comparison and a number, as in 'LAMP == 1', found"):
        Condition.parse(text)


def test_a_missing_value_a_text_and_a_vector_never_hold():  # R-X07
    for relation in RELATIONS:
        parse = Condition.parse(f"X {relation} 1")
        for values in ({}, {"X": "1"}, {"X": [1.0]}, {"X": None}):
            assert not parse.holds(values)
    assert Condition.parse("X[3] == 1").value_of({"X": [1.0, 2.0]}) is None
    assert Condition.parse("X[0] == 1").value_of({"X": 1.0}) is None
    assert not Condition.parse("X == 1").holds({"X": math.nan})
