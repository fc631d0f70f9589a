"""The protocol with an outside partner, without any connection."""

import json

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.runtime.partner.protocol import LONGEST, UNASKED, PartnerProtocol


def line(**fields):
    return json.dumps(fields).encode() + b"\n"


@pytest.fixture
def protocol():
    protocol = PartnerProtocol()
    protocol.ask("home/one", "path", {})
    return protocol


def test_a_question_is_one_line_of_json():  # R-F04
    line = PartnerProtocol().ask("home/one", "path", {"start": np.array([0.5, 1.0]), "n": np.float64(2.0)})
    assert line.endswith(b"}\n")
    assert line.count(b"\n") == 1
    wanted = {"onika": 1, "id": 1, "task": "home/one", "ask": "path", "start": [0.5, 1.0], "n": 2.0}
    assert json.loads(line) == wanted


def test_what_is_not_finite_goes_as_null():  # R-F04: JSON has no NaN
    assert json.loads(PartnerProtocol().ask("t", "show", {"x": [float("nan"), 1.0]}))["x"] == [None, 1.0]


@pytest.mark.parametrize(
    ("fields", "reason"),
    [
        ({"id": 3}, "of other names than"),
        ({"x": object()}, "that JSON can hold"),
        ({"x": "a" * LONGEST}, "of at most 65536 bytes"),
    ],
)
def test_a_question_that_cannot_be_asked_is_refused_and_not_counted(fields, reason):
    protocol = PartnerProtocol()
    with pytest.raises(ValueError, match=reason):
        protocol.ask("t", "show", fields)
    assert (protocol.questions, protocol.is_open) == (0, False)


def test_an_answer_closes_its_question_however_it_is_cut(protocol):  # R-F04
    for byte in line(id=1, via=[]):
        assert protocol.is_open
        protocol.take(bytes([byte]))
    assert (protocol.is_open, protocol.answer) == (False, {"id": 1, "via": []})


def test_an_answer_to_a_question_that_was_given_up_is_passed_over(protocol):  # R-F04: too late
    protocol.give_up()
    protocol.ask("home/one", "path", {})
    protocol.take(line(id=1, x="old") + line(id=2, x="new"))
    assert (protocol.answer["x"], protocol.late) == ("new", 1)


def test_a_second_answer_to_one_question_is_passed_over(protocol):
    protocol.take(line(id=1, x=1) + line(id=1, x=2))
    assert (protocol.answer["x"], protocol.late) == (1, 1)


@pytest.mark.parametrize(
    "line",
    [
        *(b"hello\n", b"[1]\n", b"{}\n", b"7\n", line(id="1"), line(id=2), line(id=0), line(id=-1), line(id=1.0)),
        *(line(id=True), b'{"id": NaN}\n', b"\xff\xfe\n", b"[" * 5000 + b"\n", b"\n"),
    ],
)
def test_what_is_no_answer_breaks_the_rules(protocol, line):  # R-F04: a partner that lies
    with pytest.raises(ValueError, match="expected"):
        protocol.take(line)
    assert protocol.answer is None


@pytest.mark.parametrize("end", [b"", b"\n"])
def test_a_line_without_end_breaks_the_rules(protocol, end):  # R-F04
    with pytest.raises(ValueError, match="lines of at most 65536 bytes"):
        for _ in range(3):
            protocol.take(b"x" * (LONGEST // 2))
        protocol.take(end)


def test_a_flood_of_answers_that_nobody_waits_for_breaks_the_rules(protocol):  # R-F04
    protocol.give_up()
    protocol.take(line(id=1) * UNASKED)
    with pytest.raises(ValueError, match="one answer to each question"):
        protocol.take(line(id=1))


def test_a_new_connection_forgets_the_half_line_of_the_old_one(protocol):
    protocol.take(b'{"id": 1, "x"')
    protocol.begin()
    protocol.take(line(id=1, x=3))
    assert protocol.answer == {"id": 1, "x": 3}


@given(st.binary(max_size=200), st.integers(0, 200))
def test_any_bytes_are_an_answer_a_rest_or_a_broken_rule(line, cut):  # R-F04
    protocol = PartnerProtocol()
    protocol.ask("t", "a", {})
    try:
        protocol.take(line[:cut])
        protocol.take(line[cut:])
    except ValueError:
        pass
    assert protocol.answer is None or protocol.answer["id"] == 1
