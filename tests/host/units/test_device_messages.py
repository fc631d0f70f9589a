import pytest
from hypothesis import given, strategies as st
from msgspec import MsgspecError

from onika.host.units.device_messages import (
    ClaimDevice,
    Denied,
    DriveChanged,
    FenceWriter,
    ModesTaken,
    OpenWorld,
    Question,
    StopAll,
    TouchPart,
    decode_order,
    decode_word,
    encode,
)
from onika.ring.drive import DriveMode
from onika.words.reason import Reason

NAMES = st.text(max_size=20)
COUNTS = st.integers(0, 2**62)
ORDERS = st.one_of(
    st.builds(OpenWorld, NAMES),
    st.builds(ClaimDevice, NAMES, COUNTS),
    st.builds(FenceWriter, COUNTS),
    st.builds(StopAll),
    st.builds(TouchPart, NAMES, NAMES, st.floats(allow_nan=False)),
)
WORDS = st.one_of(
    st.builds(Denied, st.just(Reason.of("host.not_open"))),
    st.builds(DriveChanged, NAMES, NAMES, COUNTS, COUNTS, COUNTS, COUNTS, st.just(Reason.of("host.not_open"))),
    st.builds(ModesTaken, st.dictionaries(NAMES, st.sampled_from(DriveMode), max_size=3)),
)


@given(ORDERS, WORDS)
def test_orders_and_words_come_as_they_were_said(order, word):  # law 16
    assert (decode_order(encode(order)), decode_word(encode(word))) == (order, word)


@given(ORDERS, WORDS)
def test_neither_is_taken_for_the_other(order, word):
    with pytest.raises(MsgspecError):
        decode_word(encode(order))
    with pytest.raises(MsgspecError):
        decode_order(encode(word))


def test_a_stop_waits_behind_no_question():  # law 27
    assert not isinstance(StopAll(), Question) and isinstance(ClaimDevice("cell:arm", 1), Question)
