import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.wire.frame import FrameReader, frame

PAYLOADS = st.lists(st.binary(min_size=1, max_size=50), max_size=8)


@settings(max_examples=examples(100), deadline=None)
@given(PAYLOADS, st.lists(st.integers(1, 20), min_size=1, max_size=10))
def test_payloads_come_out_as_they_went_in_however_the_bytes_are_cut(payloads, cuts):  # R-F01
    stream = b"".join(frame(payload) for payload in payloads)
    reader = FrameReader()
    out, at, turn = [], 0, 0
    while at < len(stream):
        size = cuts[turn % len(cuts)]
        out += reader.feed(stream[at : at + size])
        at, turn = at + size, turn + 1
    assert out == payloads
    assert reader.is_between_frames


@settings(max_examples=examples(200), deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes_give_payloads_within_the_limit_or_a_value_error(stream):
    reader = FrameReader(limit=16)
    try:
        payloads = reader.feed(stream)
    except ValueError:
        with pytest.raises(ValueError, match="expected a frame of 1 to 16 bytes"):
            reader.feed(b"")
    else:
        assert all(1 <= len(payload) <= 16 for payload in payloads)
        assert stream.startswith(b"".join(frame(payload) for payload in payloads))


@pytest.mark.parametrize("length", [0, 17, 2**32 - 1])
def test_an_impossible_length_is_refused_before_its_bytes_are_there(length):
    with pytest.raises(ValueError, match=f"found one of {length}"):
        FrameReader(limit=16).feed(length.to_bytes(4, "big"))


@pytest.mark.parametrize("payload", [b"", bytes(17)])
def test_an_empty_or_too_long_payload_is_not_framed(payload):
    with pytest.raises(ValueError, match="expected a frame of 1 to 16 bytes"):
        frame(payload, limit=16)


def test_a_reader_knows_that_it_is_in_the_middle_of_a_frame():
    reader = FrameReader()
    reader.feed(frame(b"whole") + b"\0\0")
    assert not reader.is_between_frames
