"""Writes a recording: an MCAP file whose chunks are written often, so that a killed run loses its last moment only.

Rare records are written by the MCAP library; messages, of which there are thousands a second, are packed here.
"""

from array import array
from collections.abc import Mapping, Sequence
from itertools import count
from struct import Struct
from typing import BinaryIO
from zlib import crc32

import zstandard
from mcap.data_stream import RecordBuilder
from mcap.opcode import Opcode
from mcap.records import (
    Attachment,
    AttachmentIndex,
    Channel,
    Chunk,
    ChunkIndex,
    DataEnd,
    Footer,
    Header,
    McapRecord,
    Metadata,
    MetadataIndex,
    Schema,
    Statistics,
    SummaryOffset,
)

from onika import __version__

MAGIC = b"\x89MCAP0\r\n"
PROFILE = "onika"
_FULL = 1 << 19
"""Bytes of messages after which a chunk goes out in any case; half a second mostly holds less, so that none overlap."""
_SAID = int(Opcode.MESSAGE)
_MESSAGE = Struct("<BQHIQQ")
_INDEX = Struct("<BQHI")
_FOOTER = Struct("<BQQQI")


class Writer:
    """Times are nanoseconds since the run's start. `stream` only has to write; it is not closed here.

    Raises OSError where the stream cannot take what is written.
    """

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._at = 0
        self._schemas: dict[str, Schema] = {}
        self._channels: dict[str, Channel] = {}
        self._counts: dict[int, int] = {}
        self._attachments: list[AttachmentIndex] = []
        self._notes: list[MetadataIndex] = []
        self._chunks: list[ChunkIndex] = []
        self._body = bytearray()
        self._index: dict[int, array[int]] = {}
        self._span: tuple[int, int] | None = None
        self._compress = zstandard.ZstdCompressor(level=1).compress
        self._put(MAGIC)
        self._write(Header(PROFILE, f"onika {__version__}"))

    @property
    def written(self) -> int:
        """Bytes that went to the stream."""
        return self._at

    def channel(self, topic: str, title: str, schema: bytes, metadata: Mapping[str, str] | None = None) -> int:
        """The number of a topic's channel; made at its first mention, with a JSON schema that is called `title`."""
        if topic not in self._channels:
            if title not in self._schemas:
                self._schemas[title] = Schema(len(self._schemas) + 1, schema, "jsonschema", title)
                self._write(self._schemas[title])
            number = len(self._channels) + 1
            self._channels[topic] = Channel(number, topic, "json", dict(metadata or {}), self._schemas[title].id)
            self._counts[number] = 0
            self._write(self._channels[topic])
        return self._channels[topic].id

    def message(self, channel: int, at_ns: int, body: bytes) -> None:
        """A message of JSON on a channel."""
        self.messages(channel, (at_ns,), (body,))

    def messages(self, channel: int, times: Sequence[int], bodies: Sequence[bytes]) -> None:
        """Many on one channel, in the order in which they were said."""
        index, at = self._index.setdefault(channel, array("Q")), len(self._body)
        parts: list[bytes] = []
        for number, at_ns, body in zip(count(self._counts[channel]), times, bodies):
            index.extend((at_ns, at))
            parts += (_MESSAGE.pack(_SAID, 22 + len(body), channel, number & 0xFFFF_FFFF, at_ns, at_ns), body)
            at += _MESSAGE.size + len(body)
        self._counts[channel] += len(bodies)
        self._body += b"".join(parts)
        if len(self._body) >= _FULL:
            self.flush()

    def attach(self, name: str, media_type: str, data: bytes) -> None:
        """A file within the file."""
        at = self._at
        self._write(Attachment(0, 0, name, media_type, data))
        self._attachments.append(AttachmentIndex(at, self._at - at, 0, 0, len(data), name, media_type))

    def note(self, name: str, words: Mapping[str, str]) -> None:
        """Words about the recording, by key."""
        at = self._at
        self._write(Metadata(name, dict(words)))
        self._notes.append(MetadataIndex(at, self._at - at, name))

    def flush(self) -> None:
        """Let out what was said since the last time, as a chunk of its own."""
        if not self._body:
            return
        body, index = bytes(self._body), self._index
        self._body, self._index = bytearray(), {}
        first = min(min(entries[::2]) for entries in index.values())
        last = max(max(entries[::2]) for entries in index.values())
        packed, at = self._compress(body), self._at
        self._write(Chunk("zstd", packed, last, first, crc32(body), len(body)))
        length, offsets, parts, end = self._at - at, {}, [], self._at
        for channel, entries in index.items():
            packed_entries = entries.tobytes()
            size = len(packed_entries)
            parts += [_INDEX.pack(Opcode.MESSAGE_INDEX, 6 + size, channel, size), packed_entries]
            offsets[channel] = end
            end += _INDEX.size + size
        self._put(b"".join(parts))
        self._chunks.append(
            ChunkIndex(length, at, "zstd", len(packed), last, end - at - length, offsets, first, len(body))
        )
        self._span = (first, last) if self._span is None else (min(first, self._span[0]), max(last, self._span[1]))

    def finish(self) -> None:
        """The summary, by which readers find their way; nothing is written after it."""
        self.flush()
        self._write(DataEnd(0))
        summary, start, offsets = RecordBuilder(), self._at, RecordBuilder()
        groups: list[tuple[Opcode, list[McapRecord]]] = [
            (Opcode.SCHEMA, list(self._schemas.values())),
            (Opcode.CHANNEL, list(self._channels.values())),
            (Opcode.STATISTICS, [self._statistics()]),
            (Opcode.CHUNK_INDEX, list(self._chunks)),
            (Opcode.ATTACHMENT_INDEX, list(self._attachments)),
            (Opcode.METADATA_INDEX, list(self._notes)),
        ]
        for opcode, records in groups:
            at = summary.count
            for record in records:
                record.write(summary)
            if records:
                SummaryOffset(int(opcode), start + at, summary.count - at).write(offsets)
        body = _taken(summary)
        offsets_at = start + len(body)
        body += _taken(offsets)
        footer = _FOOTER.pack(Opcode.FOOTER, 20, start, offsets_at, 0)[:-4]
        self._put(body)
        self._write(Footer(start, offsets_at, crc32(footer, crc32(body))))
        self._put(MAGIC)

    def _statistics(self) -> Statistics:
        first, last = self._span or (0, 0)
        return Statistics(
            attachment_count=len(self._attachments),
            channel_count=len(self._channels),
            channel_message_counts=dict(self._counts),
            chunk_count=len(self._chunks),
            message_count=sum(self._counts.values()),
            message_end_time=last,
            message_start_time=first,
            metadata_count=len(self._notes),
            schema_count=len(self._schemas),
        )

    def _write(self, record: McapRecord) -> None:
        builder = RecordBuilder()
        record.write(builder)
        self._put(_taken(builder))

    def _put(self, data: bytes) -> None:
        self._stream.write(data)
        self._at += len(data)


def _taken(builder: RecordBuilder) -> bytes:
    data: bytes = builder.end()  # type: ignore[no-untyped-call]  # the library says no types here
    return data
