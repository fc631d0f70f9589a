import io
import os
import struct
import tracemalloc

import pytest
import zstandard
from hypothesis import HealthCheck, given, settings, strategies as st

from kit.examples import examples
from onika.record.reader import UNREADABLE, Reader, complaint
from onika.record.writer import MAGIC, Writer

SCHEMA = b'{"type":"object"}'
STEP = 10


def bytes_of(count=60, per_chunk=7, finishes=True):
    """A recording: topic a speaks at every step, b at every third; the ends of its chunks."""
    stream = io.BytesIO()
    writer, ends = Writer(stream), []
    writer.note("onika", {"seed": "3"})
    writer.attach("plan", "text/plain", b"the plan")
    for k in range(count):
        writer.message(writer.channel("a", "any", SCHEMA), k * STEP, b'{"a":%d}' % k)
        if k % 3 == 0:
            writer.message(writer.channel("b", "any", SCHEMA), k * STEP, b'{"b":%d}' % k)
        if k % per_chunk == per_chunk - 1:
            writer.flush()
            ends.append((stream.tell(), k))
    if finishes:
        writer.finish()
    return stream.getvalue(), ends


WHOLE, ENDS = bytes_of()


@pytest.fixture
def path(tmp_path):
    return tmp_path / "run.mcap"


def read(path, data):
    path.write_bytes(data)
    return Reader(path)


def test_a_whole_file_says_everything(path):  # R-X05
    reader = read(path, WHOLE)
    assert reader.is_whole
    assert reader.unread == 0
    assert reader.span == (0, 590)
    assert [at for at, _ in reader.messages("a")] == [k * STEP for k in range(60)]
    assert [body for _, body in reader.messages("b", 30, 91)] == [b'{"b":3}', b'{"b":6}', b'{"b":9}']
    chunks = list(reader.bodies("b", 30, 91))
    assert [at for times, _ in chunks for at in times] == [30, 60, 90]
    assert [body for _, bodies in chunks for body in bodies] == [b'{"b":3}', b'{"b":6}', b'{"b":9}']
    assert (reader.count("a"), reader.count("b"), reader.count("c")) == (60, 20, 0)
    assert (reader.attachment("plan"), reader.attachment("none")) == (b"the plan", None)
    assert reader.notes == {"onika": {"seed": "3"}}
    assert reader.attachments == ("plan",)
    reader.close()


@given(at=st.integers(-5, 700))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_the_newest_word_before_a_time_is_found(path, at):  # R-X05: scrubbing
    reader = read(path, WHOLE)
    messages = [(k * STEP, b'{"b":%d}' % k) for k in range(0, 60, 3) if k * STEP <= at]
    assert reader.newest("b", at) == (messages[-1] if messages else None)
    assert reader.newest("c", at) is None


@given(cut=st.integers(0, len(WHOLE) - 1))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(300))
def test_a_file_cut_anywhere_is_read_up_to_its_last_whole_chunk(path, cut):  # R-X05: kill -9
    path.write_bytes(WHOLE[:cut])
    if cut < 8:
        with pytest.raises(ValueError, match=r"expected a recording \(MCAP\)"):
            Reader(path)
        return
    reader = Reader(path)
    assert not reader.is_whole
    last = max((k for end, k in ENDS if end <= cut), default=-1)
    steps = [at // STEP for at, _ in reader.messages("a")]
    assert steps == list(range(len(steps)))
    assert len(steps) >= last + 1
    assert all(body == b'{"a":%d}' % (at // STEP) for at, body in reader.messages("a"))


@given(cut=st.integers(600, len(WHOLE) - 1), garbage=st.binary(min_size=1, max_size=40))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(200))
def test_garbage_behind_a_cut_does_no_harm(path, cut, garbage):  # R-X05
    path.write_bytes(WHOLE[:cut] + garbage)
    reader = Reader(path)
    steps = [at // STEP for at, _ in reader.messages("a")]
    last = max((k for end, k in ENDS if end <= cut), default=-1)
    assert steps[: last + 1] == list(range(last + 1))


def test_a_file_that_was_never_finished_is_read(path):
    reader = read(path, bytes_of(finishes=False)[0])
    assert not reader.is_whole
    assert reader.count("a") == 56


def test_what_is_no_recording_is_said(path):  # R-E01
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(100))
    with pytest.raises(ValueError, match="found something else"):
        Reader(path)


@given(at=st.integers(8, len(WHOLE) - 1), bit=st.integers(0, 7))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(300))
def test_a_bit_that_has_fallen_over_is_never_taken_for_what_was_said(path, at, bit):  # R-E01
    spoilt = bytearray(WHOLE)
    spoilt[at] ^= 1 << bit
    path.write_bytes(spoilt)
    try:
        reader = Reader(path)
        plan, messages = reader.attachment("plan"), dict(reader.messages("a"))
    except UNREADABLE as wrong:
        assert str(complaint(path, wrong)).startswith(f"{path}: ")
        return
    assert plan in (None, b"the plan")
    assert {*messages.values()} <= {b'{"a":%d}' % k for k in range(60)}


def chunk(size, packed):
    return (
        struct.pack("<BQQQQII", 6, 44 + len(packed), 0, 10, size, 0, 4)
        + b"zstd"
        + struct.pack("<Q", len(packed))
        + packed
    )


def zeros(size):
    return zstandard.ZstdCompressor().compress(bytes(size))


@pytest.mark.parametrize(
    "records",
    [
        chunk(2**31, zeros(2**25)),
        chunk(2**10, zeros(2**25)),
        chunk(2**23, zeros(2**23)) * 40,
        struct.pack("<BQ", 200, 0) * 200_000,
        chunk(2**20, zeros(2**20)),
        struct.pack("<BQ", 9, 30) + struct.pack("<QQI", 0, 0, 2**32 - 1) + bytes(10),
    ],
    ids=["a huge chunk", "a chunk that lies", "many chunks", "empty records", "messages of no length", "a huge name"],
)
def test_a_file_that_would_unfold_is_refused_before_it_does(path, records):  # R-B07, R-X05
    path.write_bytes(MAGIC + records + struct.pack("<BQ", 15, 4) + bytes(4) + MAGIC)
    tracemalloc.start()
    with pytest.raises(UNREADABLE) as wrong:
        list(Reader(path).messages("a"))
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 200e6
    assert str(complaint(path, wrong.value)).startswith(f"{path}: ")


def test_why_it_cannot_be_read_is_said_in_words_with_its_name(path, tmp_path):  # R-E01
    os.mkfifo(tmp_path / "pipe")
    for other, expected in ((path, "no such file"), (tmp_path, "found a folder"), (tmp_path / "pipe", "found a pipe")):
        with pytest.raises(UNREADABLE) as wrong:
            Reader(other)
        assert expected in str(complaint(other, wrong.value))
        assert str(complaint(other, wrong.value)).startswith(f"{other}: ")
    assert "one that is spoilt" in str(complaint(path, KeyError("x")))
