"""Bytes of others at the boundaries that are no requests, acts or texts of ours: link, console, kept files, recordings.

Each takes them, or refuses with a reason, and never with an exception that nobody expects (R-B07, R-F01).
"""

import contextlib
import io
from pathlib import Path
from random import Random

import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.cli.commands import carry_out
from onika.desk.environment.file import recovery_record
from onika.desk.environment.state import settings
from onika.host.sessions.heartbeat_registry import HeartbeatRegistry
from onika.link.reply_log import ReplyLog
from onika.link.server import ServerEnd
from onika.link.signal_journal import SignalJournal
from onika.wire import event
from onika.wire.frame import FrameReader, frame
from onika.wire.packet import VERSION, Ack, Beat, Bye, Hello, Part, ReplyPacket, RequestPacket, decode, encode
from onika.words.reason import NOTHING

_PACKETS = (
    Hello(VERSION, "me", "", 0),
    RequestPacket(1, 1, 0, 0, b"body"),
    RequestPacket(2, 1, 0, 3, b""),
    Part(2, 0, b"a"),
    Ack(1),
    Beat(1, 0, 0),
    ReplyPacket(1, False, 0, b""),
    Bye("closed", NOTHING),
)


def garbled(body: bytes, random: Random) -> bytes:
    """The same bytes cut, flipped, doubled, or with others in between."""
    place = random.randrange(len(body) + 1)
    choice = random.randrange(5)
    if choice == 0:
        return body[:place]
    if choice == 1:
        return body[:place] + random.randbytes(random.choice((1, 4, 40))) + body[place:]
    if choice == 2:
        return body[:place] + body[place // 2 :]
    if choice == 3:
        return body[:place] + random.choice((b"\x91", b"[", b"{", b"\xff", b"\0")) * random.choice((5, 5_000))
    flipped = bytearray(body)
    for _ in range(random.choice((1, 3, 10))):
        flipped[random.randrange(len(flipped))] = random.randrange(256)
    return bytes(flipped)


def link_hears(seed: int, count: int) -> None:
    random = Random(seed)
    for _ in range(count):
        end = ServerEnd(SignalJournal("e1"), ReplyLog())
        end.open(0)
        reader, stream = FrameReader(), bytearray()
        for _ in range(random.randrange(1, 12)):
            body = encode(random.choice(_PACKETS))
            stream += frame(garbled(body, random) or b"\0") if random.random() < 0.3 else frame(body)
        stream = bytearray(garbled(bytes(stream), random)) if random.random() < 0.3 else stream
        with contextlib.suppress(ValueError):  # the connection is cut
            for payload in reader.feed(bytes(stream)):
                end.feed(decode(payload), 1)
                end.take_packets(1, 1 << 20)
                end.take_notices()
        end.tick(10**12)


def test_no_packet_ends_the_end_of_a_link():  # R-F01
    link_hears(1, 1_500)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2, 8))
def test_no_packet_ends_the_end_of_a_link_in_a_long_time(seed):  # R-F01
    link_hears(seed, 50_000)


def test_no_datagram_counts_for_anybody_who_has_no_key():  # R-F01
    random, beats = Random(1), []
    registry = HeartbeatRegistry()
    registry.port = 1
    registry.open(beats.append)
    for length in (0, 1, 8, 16, 24, 32, 33, 40, 64):
        for _ in range(50):
            registry.take(random.randbytes(length))
    assert beats == []


@pytest.mark.parametrize("seed", range(3))
def test_no_kept_document_ends_a_beginning(seed, tmp_path):  # R-X10, R-B07
    random = Random(seed)
    honest = recovery_record.write(recovery_record.RecoveryRecord("job", "VERSION 1.3\nEOF\n")).encode()
    for _ in range(200):
        text = garbled(honest, random).decode("utf-8", "replace")
        with contextlib.suppress(ValueError):
            recovery_record.read(text)
        (tmp_path / settings.NAME).write_text(text)
        settings.read(tmp_path, {})


@pytest.fixture
def honest(tmp_path):
    builder = RecordingBuilder(tmp_path / "honest.mcap")
    builder.variable("X", "double", *((at / 10, float(at)) for at in range(20)))
    builder.variable("Q", "double[2]", (0.0, (0.0, 1.0)), (0.5, (2.0, 3.0)))
    builder.tell(0.1, event.Began(0, 0, 1, "go", 0.1))
    builder.end().close()
    return tmp_path / "honest.mcap"


def _recordings(honest: Path, seed: int, count: int) -> None:
    random, whole, path = Random(seed), honest.read_bytes(), honest.with_name("other.mcap")
    for number in range(count):
        path.write_bytes(garbled(whole, random))
        words = (["show", str(path)], ["csv", str(path)], ["diff", str(honest), str(path)])[number % 3]
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as errors:
            try:
                code = carry_out(["recording", *words])
            except SystemExit as ended:
                code = ended.code
        assert code in (0, 1, 2), (words, errors.getvalue())


def test_no_recording_ends_a_command_that_reads_it(honest):  # R-X05, R-B07
    _recordings(honest, 1, 150)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2, 12))
def test_no_recording_ends_a_command_that_reads_it_in_a_long_time(honest, seed):  # R-X05, R-B07
    _recordings(honest, seed, 3_000)
