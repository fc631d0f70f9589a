"""Reads a recording, whole or cut short: a file that ends early is read up to its last whole chunk.

It is gone through once, from record to record, without unpacking; a chunk is unpacked when something in it is wanted.
"""

import struct
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from struct import Struct
from zlib import crc32

import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Attachment, Channel, Metadata, Schema
from msgspec import MsgspecError

from onika.record.stored import StoredFile, unfit
from onika.record.writer import MAGIC
from onika.words.reason import Reason, reason_of

_RECORD = Struct("<BQ")
_CHUNK = Struct("<QQQII")
_INDEX = Struct("<HI")
_MESSAGE = Struct("<BQHIQQ")
_LEAST = 4
"""Bytes of the shortest record that says something."""
_KEPT = 48
"""Unpacked chunks that are kept: whoever looks at an instant mostly looks beside it next."""
_KEPT_BYTES = 64 * 2**20
"""What unpacked chunks may hold together; fewer are kept where they are large."""
_LARGEST_CHUNK = 16 * 2**20
"""Bytes of an unpacked chunk; ours hold a quarter of a megabyte, those of other writers about one."""
_MOST_WITHOUT_INDEX = 128 * 2**20
"""Bytes that are unpacked together to find what stands in chunks without an index."""
_MOST_EMPTY = 10_000
"""Records that say nothing; a file of nothing else is no recording."""


def complaint(path: Path, wrong: Exception) -> Reason:
    """Why a file cannot be read; the file first, which is another one where that is what could not be read."""
    reason = reason_of(wrong)
    if reason.key == "record.of_file":
        return reason
    return Reason.of("record.of_file", path=str(path), why=flaw(wrong))


def flaw(wrong: Exception) -> Reason:
    """Why a file cannot be read, without its name."""
    if isinstance(wrong, OSError):
        return Reason.plain((wrong.strerror or str(wrong)).lower())
    why = reason_of(wrong).args.get("why")
    if isinstance(why, Reason):
        return why
    return Reason.of("record.no_mcap", given=Reason.of("record.spoilt"))


def content(wrong: Exception) -> Reason:
    """What was found in a file that cannot be read."""
    why = flaw(wrong)
    given = why.args.get("given", why)
    return given if isinstance(given, Reason) else why


UNREADABLE = (
    *(OSError, ValueError, LookupError, TypeError, OverflowError, MemoryError, RecursionError),
    *(struct.error, zstandard.ZstdError, MsgspecError, McapError),
)
"""What reading a file raises that somebody else has written, or spoilt."""

Said = tuple[int, bytes]
"""When, in ns since the run's start, and the JSON."""


@dataclass(frozen=True, slots=True)
class _Chunk:
    first: int
    last: int
    at: int
    packed: int
    size: int
    sum: int
    """CRC-32 of what it holds; 0: not told."""
    index: dict[int, int]
    """By channel, where in the file its entries begin; empty: to be found by unpacking."""


class Reader:
    """Raises ValueError where a file is no MCAP file, OSError where it cannot be read."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.channels: dict[str, Channel] = {}
        self.schemas: dict[int, Schema] = {}
        self.notes: dict[str, dict[str, str]] = {}
        self.is_whole = False
        """Whether it came to its end; else it was cut short."""
        self.unread = 0
        """Bytes at the end of a file cut short that make no whole chunk."""
        self._chunks: list[_Chunk] = []
        self._attachments: dict[str, tuple[int, int]] = {}
        self._empty_records = 0
        self._stored = StoredFile(path)
        if self._stored.size < len(MAGIC) or self._stored.read(0, len(MAGIC)) != MAGIC:
            raise unfit(path, Reason.of("record.no_mcap", given=Reason.of("record.something_else")))
        self._scan()
        unindexed = sum(chunk.size for chunk in self._chunks if not chunk.index)
        if unindexed > _MOST_WITHOUT_INDEX:
            raise self._too_large(unindexed, _MOST_WITHOUT_INDEX)
        self._of: dict[int, list[int]] = {}
        """By channel, the chunks in which it speaks."""
        for number, chunk in enumerate(self._chunks):
            for channel in chunk.index or self._entries(number):
                self._of.setdefault(channel, []).append(number)
        largest = max((chunk.size for chunk in self._chunks), default=1)
        self._unpack = lru_cache(min(_KEPT, max(2, _KEPT_BYTES // max(largest, 1))))(self._unpacked)

    @property
    def span(self) -> tuple[int, int]:
        """The times of the first and the last message; 0 and 0 where there is none."""
        if not self._chunks:
            return 0, 0
        return min(chunk.first for chunk in self._chunks), max(chunk.last for chunk in self._chunks)

    def attachment(self, name: str) -> bytes | None:
        """A file within the file."""
        if name not in self._attachments:
            return None
        at, size = self._attachments[name]
        record = self._stored.read(at, size)
        if (check := int.from_bytes(record[-4:], "little")) and crc32(record[:-4]) != check:
            raise unfit(self.path, Reason.of("record.part_spoilt", part=name))
        data: bytes = Attachment.read(ReadDataStream(BytesIO(record))).data
        return data

    @property
    def attachments(self) -> tuple[str, ...]:
        """The names of the files within the file."""
        return tuple(self._attachments)

    def messages(self, topic: str, begin_ns: int = 0, end_ns: int = 1 << 63) -> Iterator[Said]:
        """What was said on a topic from `begin_ns` to before `end_ns`, in the order in which it was written."""
        channel = self.channels.get(topic)
        for number in [] if channel is None else self._of.get(channel.id, []):
            chunk = self._chunks[number]
            if channel is not None and chunk.last >= begin_ns and chunk.first < end_ns:
                for at, offset in self._index(number, channel.id):
                    if begin_ns <= at < end_ns:
                        yield at, self._body(number, offset, at)

    def bodies(self, topic: str, begin_ns: int = 0, end_ns: int = 1 << 63) -> Iterator[tuple[list[int], list[bytes]]]:
        """The same, chunk by chunk: the times and the messages."""
        channel = self.channels.get(topic)
        for number in [] if channel is None else self._of.get(channel.id, []):
            chunk = self._chunks[number]
            if channel is not None and chunk.last >= begin_ns and chunk.first < end_ns:
                entries = [entry for entry in self._index(number, channel.id) if begin_ns <= entry[0] < end_ns]
                data = self._unpack(number) if entries else b""
                yield [at for at, _ in entries], [self._message(data, offset, at) for at, offset in entries]

    def newest(self, topic: str, at_ns: int) -> Said | None:
        """What was said last on a topic, at this time or before."""
        channel = self.channels.get(topic)
        for number in reversed([] if channel is None else self._of.get(channel.id, [])):
            if channel is not None and self._chunks[number].first <= at_ns:
                times = self._index(number, channel.id)
                place = bisect_right(times, at_ns, key=lambda entry: entry[0])
                if place:
                    at, offset = times[place - 1]
                    return at, self._body(number, offset, at)
        return None

    def count(self, topic: str) -> int:
        """How many messages a topic has."""
        channel = self.channels.get(topic)
        chunks = [] if channel is None else self._of.get(channel.id, [])
        return sum(len(self._index(number, channel.id)) for number in chunks if channel is not None)

    def close(self) -> None:
        """Give the file back."""
        self._unpack.cache_clear()
        self._stored.close()

    # Inner

    def _scan(self) -> None:
        at, size = len(MAGIC), self._stored.size
        while at + _RECORD.size <= size:
            opcode, length = _RECORD.unpack(self._stored.read(at, _RECORD.size))
            end = at + _RECORD.size + length
            if opcode == Opcode.DATA_END:
                self.is_whole = self._stored.read(size - len(MAGIC), len(MAGIC)) == MAGIC
            if end > size or opcode in (0, Opcode.DATA_END):
                break
            self._take(opcode, at + _RECORD.size, length)
            at = end
        if not self.is_whole:
            self.unread = size - at
            self._judge_last()

    def _judge_last(self) -> None:
        """The last chunk of a file cut short: its index may be cut, and itself may be garbled."""
        if self._chunks:
            self._chunks[-1].index.clear()
            try:
                self._unpacked(len(self._chunks) - 1)
            except (zstandard.ZstdError, ValueError):
                self.unread += self._chunks.pop().packed

    def _take(self, opcode: int, at: int, length: int) -> None:
        match opcode:
            case Opcode.SCHEMA:
                schema = Schema.read(self._stream(at, length))
                self.schemas[schema.id] = schema
            case Opcode.CHANNEL:
                channel = Channel.read(self._stream(at, length))
                self.channels[channel.topic] = channel
            case Opcode.METADATA:
                note = Metadata.read(self._stream(at, length))
                self.notes[note.name] = note.metadata
            case Opcode.ATTACHMENT:
                name_at = at + 16
                name_size = int.from_bytes(self._stored.read(name_at, 4), "little")
                self._attachments[self._stored.read(name_at + 4, name_size).decode()] = (at, length)
            case Opcode.CHUNK:
                first, last, whole, check, name = _CHUNK.unpack(self._stored.read(at, _CHUNK.size))
                data = at + _CHUNK.size + name + 8
                if whole > _LARGEST_CHUNK:
                    raise self._too_large(whole, _LARGEST_CHUNK)
                self._chunks.append(_Chunk(first, last, data, at + length - data, whole, check, {}))
            case Opcode.MESSAGE_INDEX if self._chunks and length >= _INDEX.size:
                channel_id, _ = _INDEX.unpack(self._stored.read(at, _INDEX.size))
                self._chunks[-1].index[channel_id] = at
            case _ if length < _LEAST:
                self._empty_records += 1
                if self._empty_records > _MOST_EMPTY:
                    raise unfit(self.path, Reason.of("record.empty_records", most=_MOST_EMPTY))

    def _index(self, number: int, channel: int) -> list[tuple[int, int]]:
        """The times of a channel's messages in a chunk, and where they begin in it."""
        at = self._chunks[number].index.get(channel)
        if at is None:
            return self._entries(number).get(channel, [])
        _, size = _INDEX.unpack(self._stored.read(at, _INDEX.size))
        words = memoryview(self._stored.read(at + _INDEX.size, size)).cast("Q")
        return sorted(zip(words[::2], words[1::2], strict=True), key=lambda entry: entry[0])

    def _entries(self, number: int) -> dict[int, list[tuple[int, int]]]:
        """The same of all channels, from the chunk itself."""
        data, at = self._unpacked(number), 0
        index: dict[int, list[tuple[int, int]]] = {}
        while at + _MESSAGE.size <= len(data):
            _, length, channel, _, time, _ = _MESSAGE.unpack_from(data, at)
            if length < _MESSAGE.size - _RECORD.size:
                raise unfit(self.path, Reason.of("record.no_mcap", given=Reason.of("record.spoilt")))
            index.setdefault(channel, []).append((time, at))
            at += _RECORD.size + length
        return {channel: sorted(entries, key=lambda entry: entry[0]) for channel, entries in index.items()}

    def _body(self, number: int, offset: int, at: int) -> bytes:
        return self._message(self._unpack(number), offset, at)

    def _message(self, data: bytes, offset: int, at: int) -> bytes:
        """The message of this time that begins there in an unpacked chunk."""
        opcode, length, _, _, time, _ = _MESSAGE.unpack_from(data, offset)
        if opcode != Opcode.MESSAGE or time != at:
            raise unfit(self.path, Reason.of("record.message_misplaced"))
        return data[offset + _MESSAGE.size : offset + _RECORD.size + length]

    def _unpacked(self, number: int) -> bytes:
        chunk = self._chunks[number]
        packed = self._stored.read(chunk.at, chunk.packed)
        told = zstandard.frame_content_size(packed)
        if told > chunk.size:  # the frame's word would count, not ours
            raise self._too_large(told, chunk.size)
        data: bytes = zstandard.ZstdDecompressor().decompress(packed, max_output_size=chunk.size)
        if chunk.sum and crc32(data) != chunk.sum:
            raise unfit(self.path, Reason.of("record.bytes_spoilt", at=chunk.at))
        return data

    def _too_large(self, size: int, most: int) -> ValueError:
        return unfit(self.path, Reason.of("record.too_large", most=most, size=size))

    def _stream(self, at: int, size: int) -> ReadDataStream:
        return ReadDataStream(BytesIO(self._stored.read(at, size)))
