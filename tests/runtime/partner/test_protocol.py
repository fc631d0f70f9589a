"""The dialogue with an outside partner, without any connection."""

import json

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.runtime.partner.protocol import LONGEST, UNASKED, Dialogue


def line(**fields):
    return json.dumps(fields).encode() + b"\n"


@pytest.fixture
def asked():
    dialogue = Dialogue()
    dialogue.ask("home/one", "path", {})
    return dialogue


def test_a_question_is_one_line_of_json():  # R-F04
    said = Dialogue().ask("home/one", "path", {"start": np.array([0.5, 1.0]), "n": np.float64(2.0)})
    assert said.endswith(b"}\n")
    assert said.count(b"\n") == 1
    wanted = {"onika": 1, "id": 1, "task": "home/one", "ask": "path", "start": [0.5, 1.0], "n": 2.0}
    assert json.loads(said) == wanted


def test_what_is_not_finite_goes_as_null():  # R-F04: JSON has no NaN
    assert json.loads(Dialogue().ask("t", "show", {"x": [float("nan"), 1.0]}))["x"] == [None, 1.0]


@pytest.mark.parametrize(
    ("fields", "reason"),
    [
        ({"id": 3}, "of other names than"),
        ({"x": object()}, "that JSON can hold"),
        ({"x": "a" * LONGEST}, "of at most 65536 bytes"),
    ],
)
def test_a_question_that_cannot_be_asked_is_refused_and_not_counted(fields, reason):
    dialogue = Dialogue()
    with pytest.raises(ValueError, match=reason):
        dialogue.ask("t", "show", fields)
    assert (dialogue.questions, dialogue.is_open) == (0, False)


def test_an_answer_closes_its_question_however_it_is_cut(asked):  # R-F04
    for byte in line(id=1, via=[]):
        assert asked.is_open
        asked.take(bytes([byte]))
    assert (asked.is_open, asked.answer) == (False, {"id": 1, "via": []})


def test_an_answer_to_a_question_that_was_given_up_is_passed_over(asked):  # R-F04: too late
    asked.give_up()
    asked.ask("home/one", "path", {})
    asked.take(line(id=1, x="old") + line(id=2, x="new"))
    assert (asked.answer["x"], asked.late) == ("new", 1)


def test_a_second_answer_to_one_question_is_passed_over(asked):
    asked.take(line(id=1, x=1) + line(id=1, x=2))
    assert (asked.answer["x"], asked.late) == (1, 1)


@pytest.mark.parametrize(
    "said",
    [
        *(b"hello\n", b"[1]\n", b"{}\n", b"7\n", line(id="1"), line(id=2), line(id=0), line(id=-1), line(id=1.0)),
        *(line(id=True), b'{"id": NaN}\n', b"\xff\xfe\n", b"[" * 5000 + b"\n", b"\n"),
    ],
)
def test_what_is_no_answer_breaks_the_rules(asked, said):  # R-F04: a partner that lies
    with pytest.raises(ValueError, match="expected"):
        asked.take(said)
    assert asked.answer is None


@pytest.mark.parametrize("end", [b"", b"\n"])
def test_a_line_without_end_breaks_the_rules(asked, end):  # R-F04
    with pytest.raises(ValueError, match="lines of at most 65536 bytes"):
        for _ in range(3):
            asked.take(b"x" * (LONGEST // 2))
        asked.take(end)


def test_a_flood_of_answers_that_nobody_waits_for_breaks_the_rules(asked):  # R-F04
    asked.give_up()
    asked.take(line(id=1) * UNASKED)
    with pytest.raises(ValueError, match="one answer to each question"):
        asked.take(line(id=1))


def test_a_new_connection_forgets_the_half_line_of_the_old_one(asked):
    asked.take(b'{"id": 1, "x"')
    asked.begin()
    asked.take(line(id=1, x=3))
    assert asked.answer == {"id": 1, "x": 3}


@given(st.binary(max_size=200), st.integers(0, 200))
def test_any_bytes_are_an_answer_a_rest_or_a_broken_rule(said, cut):  # R-F04
    dialogue = Dialogue()
    dialogue.ask("t", "a", {})
    try:
        dialogue.take(said[:cut])
        dialogue.take(said[cut:])
    except ValueError:
        pass
    assert dialogue.answer is None or dialogue.answer["id"] == 1
