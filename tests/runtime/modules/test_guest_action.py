"""The adapter of a guest on the bench: what it asks, how it ends, and that the guest learns when it goes off."""

import pytest

from onika.model.lifecycle import State
from onika.testing.bench import Bench
from onika.testing.fake_partner import FakePartner

CODE = """
from onika.module import GuestAction, Input, InVar, OutVar


class Place(GuestAction):
    action = "place"
    box = Input("int", "-", "which box")
    note = Input("line", "-", "what for", default="")
    Qd = InVar("double[2]", "rad/s", "speeds", name="Q^")
    SPOT = OutVar("double[2]", "m", "where to")
    COUNT = OutVar("int", "-", "how many")
    WORDS = OutVar("line", "-", "why")
"""
LOCAL = {"GUEST": "oracle", "PATIENCE": 10.0}


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


@pytest.fixture
def bench(outsider, tmp_path):
    path = tmp_path / "place.py"
    path.write_text(CODE)
    bench = Bench(path, frequency=20, local=LOCAL | {"PARTNER": outsider.address}, is_synchronous=True).init()
    bench["Q^"] = (1.0, 2.0)
    return bench.on("3 for_the_tower").cycle()


def ended(bench, outsider, **fields):
    """The bench after this answer."""
    call = outsider.accept()
    call.answer(call.read(), **fields)
    return bench.event()


def test_it_asks_for_its_action_with_the_target_and_what_its_inputs_hold(bench, outsider):  # R-A20
    question = outsider.accept().read()
    assert question["ask"] == "do"
    assert question["action"] == "place"
    assert question["target"] == {"box": 3, "note": "for_the_tower"}
    assert question["values"] == {"Q^": [1.0, 2.0]}
    assert bench.state is State.ON


def test_it_ends_as_the_guest_says(bench, outsider):  # R-A20
    ended(bench, outsider, flow=2, loop=True)
    assert (bench.finished.flow, bench.finished.loop) == (2, True)


def test_without_more_it_ends_with_flow_0(bench, outsider):  # R-A20
    ended(bench, outsider)
    assert (bench.finished.flow, bench.finished.loop) == (0, False)


def test_what_the_guest_gives_stands_in_its_outputs_and_what_it_says_is_told(bench, outsider):  # R-A20
    values = {"SPOT": [0.5, -0.25], "COUNT": 2, "WORDS": "it fits"}
    ended(bench, outsider, values=values, says="two\nlines")
    assert bench["SPOT"].tolist() == [0.5, -0.25]
    assert (bench["COUNT"], bench["WORDS"]) == (2, "it fits")
    assert [str(warning) for warning in bench.warnings] == ["it says: two lines"]


LIES = {
    "a flow that is none": {"flow": -1},
    "half a flow": {"flow": 0.5},
    "a flow in words": {"flow": "left"},
    "a loop that is no truth value": {"loop": 1},
    "values that are none": {"values": [1, 2]},
    "a value for an input": {"values": {"Q^": [0, 0]}},
    "a value for nothing": {"values": {"SPOT": [0, 0], "SECRET": 1}},
    "too few numbers": {"values": {"COUNT": 1, "SPOT": [0]}},
    "texts": {"values": {"COUNT": 1, "SPOT": ["0", "0"]}},
    "null": {"values": {"COUNT": 1, "SPOT": [None, 0]}},
    "more than the type can hold": {"values": {"SPOT": [1, 1], "COUNT": 10**12}},
    "a number for a text": {"values": {"COUNT": 1, "WORDS": 5}},
    "words that are none": {"values": {"COUNT": 1}, "says": 4},
    "a refusal": {"error": "no"},
}


@pytest.mark.parametrize("lie", LIES)
def test_an_answer_that_makes_no_sense_is_an_error_and_writes_nothing(bench, outsider, lie):  # R-A20
    before = bench["SPOT"].tolist(), bench["COUNT"], bench["WORDS"]
    ended(bench, outsider, **LIES[lie])
    assert bench.state is State.ERROR
    assert bench.finished is None
    assert (bench["SPOT"].tolist(), bench["COUNT"], bench["WORDS"]) == before


def test_a_message_names_the_guest(bench, outsider):  # R-A20
    ended(bench, outsider, error="the moon is in the wrong house")
    assert "partner oracle: it says: the moon is in the wrong house" in str(bench.why)


def test_when_it_goes_off_unanswered_the_guest_sees_that_nobody_waits(bench, outsider):  # R-A20, R-E13
    call = outsider.accept()
    call.read()
    assert not call.has_ended()
    bench.off()
    assert call.has_ended()


def test_when_it_was_answered_the_connection_stays(bench, outsider):  # R-A20
    call = outsider.accept()
    call.answer(call.read())
    bench.event()
    bench.on("4 again").cycle()
    assert call.read()["target"]["box"] == 4
    assert not call.has_ended()
