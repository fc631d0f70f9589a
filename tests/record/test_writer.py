import io

import pytest
from hypothesis import given, strategies as st
from mcap.reader import NonSeekingReader, make_reader

from onika.record.writer import Writer

SCHEMA = b'{"type":"object"}'
MESSAGES = st.lists(
    st.tuples(st.sampled_from("abc"), st.integers(0, 2**62), st.binary(max_size=40), st.booleans()), max_size=40
)


def written(messages):
    stream = io.BytesIO()
    writer = Writer(stream)
    writer.note("onika", {"seed": "3"})
    writer.attach("plan", "text/plain", b"the plan")
    for topic, at, body, flushes in messages:
        writer.message(writer.channel(topic, "any", SCHEMA, {"unit": "m"}), at, body)
        if flushes:
            writer.flush()
    writer.finish()
    stream.seek(0)
    return stream


@given(MESSAGES)
def test_other_readers_of_mcap_find_everything(messages):  # R-X05: opens in Foxglove
    expected = sorted((topic, at, body) for topic, at, body, _ in messages)
    stream = written(messages)
    messages = [
        (channel.topic, message.log_time, message.data)
        for _, channel, message in make_reader(stream, validate_crcs=True).iter_messages()
    ]
    assert sorted(messages) == expected
    stream.seek(0)
    straight = NonSeekingReader(stream, validate_crcs=True).iter_messages()
    assert sorted((channel.topic, message.log_time, message.data) for _, channel, message in straight) == expected


def test_the_summary_tells_what_is_there():
    stream = written([("a", 5, b"{}", True), ("b", 3, b"{}", False), ("a", 9, b"{}", False)])
    reader = make_reader(stream)
    summary = reader.get_summary()
    assert (summary.statistics.message_count, summary.statistics.chunk_count) == (3, 2)
    assert (summary.statistics.message_start_time, summary.statistics.message_end_time) == (3, 9)
    assert {channel.topic: channel.metadata for channel in summary.channels.values()} == {
        "a": {"unit": "m"},
        "b": {"unit": "m"},
    }
    assert [attachment.data for attachment in reader.iter_attachments()] == [b"the plan"]
    assert next(iter(reader.iter_metadata())).metadata == {"seed": "3"}


def test_a_full_chunk_goes_out_by_itself():  # R-X05: what is written is readable
    stream = io.BytesIO()
    writer = Writer(stream)
    channel = writer.channel("a", "any", SCHEMA)
    for at in range(600):
        writer.message(channel, at, bytes(1000))
    assert stream.tell() > 0
    before = stream.tell()
    writer.flush()
    writer.flush()
    assert stream.tell() > before


def test_a_stream_that_cannot_take_it_is_an_error():
    class Full(io.BytesIO):
        def write(self, data):
            raise OSError("no space left")

    with pytest.raises(OSError, match="no space left"):
        Writer(Full())


def test_many_messages_at_once_are_the_same_as_one_after_the_other():
    def stream(say):
        buffer = io.BytesIO()
        writer = Writer(buffer)
        writer.message(writer.channel("b", "any", SCHEMA), 1, b"{}")
        say(writer, writer.channel("a", "any", SCHEMA))
        writer.finish()
        return buffer.getvalue()

    def one_by_one(writer, channel):
        for at in range(5):
            writer.message(channel, at, b"[%d]" % 10**at)

    def at_once(writer, channel):
        writer.messages(channel, range(5), [b"[%d]" % 10**at for at in range(5)])

    assert stream(one_by_one) == stream(at_once)
