import msgspec
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.wire.packet import (
    Ack,
    Beat,
    Bye,
    Hello,
    Packet,
    Part,
    ReadingPacket,
    ReplyPacket,
    RequestPacket,
    SignalPacket,
    Welcome,
    decode,
    encode,
)
from onika.words.reason import Reason

COUNT = st.integers(0, 2**63 - 1)
NAME = st.text(max_size=128)
PACKETS = st.one_of(
    st.builds(Hello, COUNT, NAME, NAME, COUNT),
    st.builds(Welcome, COUNT, NAME, COUNT, st.booleans(), COUNT),
    st.builds(RequestPacket, COUNT, COUNT, COUNT, COUNT, st.binary()),
    st.builds(ReplyPacket, COUNT, st.booleans(), COUNT, st.binary()),
    st.builds(Part, COUNT, COUNT, st.binary()),
    st.builds(SignalPacket, COUNT, st.binary()),
    st.builds(Ack, COUNT),
    st.builds(ReadingPacket, COUNT, NAME, st.binary()),
    st.builds(Beat, COUNT, COUNT),
    st.builds(Bye, st.sampled_from(["closed", "version", "garbage", "behind"]), st.text(max_size=1000)),
    st.builds(Bye, st.sampled_from(["closed", "garbage", "refused"]), st.builds(Reason.plain, st.text(max_size=1000))),
)


@settings(max_examples=examples(300), deadline=None)
@given(st.binary(max_size=100))
def test_any_bytes_are_a_packet_or_a_value_error(payload):
    try:
        packet = decode(payload)
    except ValueError as fault:
        assert "expected a packet" in str(fault)
    else:
        assert isinstance(packet, Packet)


@settings(max_examples=examples(100), deadline=None)
@given(PACKETS, st.data())
def test_a_packet_that_is_cut_short_or_followed_by_more_is_refused(packet, data):
    whole = encode(packet)
    with pytest.raises(ValueError, match="expected a packet"):
        decode(whole[: data.draw(st.integers(0, len(whole) - 1))])
    with pytest.raises(ValueError, match="expected a packet"):
        decode(whole + b"\0")


@pytest.mark.parametrize(
    "words",
    [
        ["ack"],
        ["ack", -1],
        ["ack", 2**63],
        ["ack", 1, 2],
        ["ack", "1"],
        ["ack", 1.0],
        ["nonsense", 1],
        ["hello", 1, "x" * 129, "", 0],
        ["bye", "because", "of that"],
        ["signal", 1, "text"],
        {"type": "ack", "seq": 1},
    ],
)
def test_what_is_nearly_a_packet_is_refused(words):
    with pytest.raises(ValueError, match="expected a packet"):
        decode(msgspec.msgpack.encode(words))


def test_the_good_bye_between_two_versions_has_the_form_that_every_version_reads():  # R-B06
    refusal = "this runtime speaks version 9 of the link, not 3"
    assert msgspec.msgpack.decode(encode(Bye("version", refusal))) == ["bye", "version", refusal]
    assert decode(encode(Bye("version", refusal))) == Bye("version", refusal)


def test_a_million_letters_in_the_place_of_a_word_are_refused_in_a_short_sentence():
    with pytest.raises(ValueError, match="expected a packet of the link") as refusal:
        decode(msgspec.msgpack.encode(["bye", "x" * 1_000_000, ""]))
    assert len(str(refusal.value)) < 500
