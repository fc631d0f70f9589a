"""Reads a recording, whole or cut short: a file that ends in the midst of anything is read up to its last whole chunk.

It is gone through once, from record to record, without unpacking; a chunk is unpacked when something in it is wanted.
"""

import mmap
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from struct import Struct

import zstandard
from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.records import Attachment, Channel, Metadata

from onika.record.writer import MAGIC

_RECORD = Struct("<BQ")
_CHUNK = Struct("<QQQII")
_INDEX = Struct("<HI")
_MESSAGE = Struct("<BQHIQQ")
_KEPT = 48
"""Unpacked chunks that are kept: whoever looks at an instant mostly looks beside it next."""

Said = tuple[int, bytes]
"""When, in ns since the run's start, and the JSON."""


@dataclass(frozen=True, slots=True)
class _Chunk:
    first: int
    last: int
    at: int
    packed: int
    size: int
    index: dict[int, int]
    """By channel, where in the file its entries begin; empty: to be found by unpacking."""


class Reader:
    """Raises ValueError where a file is no MCAP file, OSError where it cannot be read."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.channels: dict[str, Channel] = {}
        self.notes: dict[str, dict[str, str]] = {}
        self.is_whole = False
        """Whether it came to its end; else it was cut short."""
        self.unread = 0
        """Bytes at the end of a file cut short that make no whole chunk."""
        self._chunks: list[_Chunk] = []
        self._attachments: dict[str, tuple[int, int]] = {}
        with path.open("rb") as stream:
            if stream.read(len(MAGIC)) != MAGIC:
                raise ValueError(f"{path}: expected a recording (MCAP), found something else")
            self._map = mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ)
        self._view = memoryview(self._map)
        self._scan()
        self._of: dict[int, list[int]] = {}
        """By channel, the chunks in which it speaks."""
        for number, chunk in enumerate(self._chunks):
            for channel in chunk.index or self._entries(number):
                self._of.setdefault(channel, []).append(number)
        self._unpack = lru_cache(_KEPT)(self._unpacked)

    @property
    def span(self) -> tuple[int, int]:
        """The times of the first and the last message; 0 and 0 where there is none."""
        if not self._chunks:
            return 0, 0
        return min(one.first for one in self._chunks), max(one.last for one in self._chunks)

    def attachment(self, name: str) -> bytes | None:
        """A file within the file."""
        if name not in self._attachments:
            return None
        at, size = self._attachments[name]
        data: bytes = Attachment.read(self._stream(at, size)).data
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
                        yield at, self._body(number, offset)

    def newest(self, topic: str, at_ns: int) -> Said | None:
        """What was said last on a topic, at this time or before."""
        channel = self.channels.get(topic)
        for number in reversed([] if channel is None else self._of.get(channel.id, [])):
            if channel is not None and self._chunks[number].first <= at_ns:
                times = self._index(number, channel.id)
                place = bisect_right(times, at_ns, key=lambda one: one[0])
                if place:
                    return times[place - 1][0], self._body(number, times[place - 1][1])
        return None

    def count(self, topic: str) -> int:
        """How many messages a topic has."""
        channel = self.channels.get(topic)
        chunks = [] if channel is None else self._of.get(channel.id, [])
        return sum(len(self._index(number, channel.id)) for number in chunks if channel is not None)

    def close(self) -> None:
        """Give the file back."""
        self._unpack.cache_clear()
        self._view.release()
        self._map.close()

    # Inner

    def _scan(self) -> None:
        at, size = len(MAGIC), len(self._view)
        while at + _RECORD.size <= size:
            opcode, length = _RECORD.unpack_from(self._view, at)
            end = at + _RECORD.size + length
            if opcode == Opcode.DATA_END:
                self.is_whole = self._map[-len(MAGIC) :] == MAGIC
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
            except zstandard.ZstdError:
                self.unread += self._chunks.pop().packed

    def _take(self, opcode: int, at: int, length: int) -> None:
        match opcode:
            case Opcode.CHANNEL:
                channel = Channel.read(self._stream(at, length))
                self.channels[channel.topic] = channel
            case Opcode.METADATA:
                note = Metadata.read(self._stream(at, length))
                self.notes[note.name] = note.metadata
            case Opcode.ATTACHMENT:
                name_at = at + 16
                name_size = int.from_bytes(self._view[name_at : name_at + 4], "little")
                name = str(self._view[name_at + 4 : name_at + 4 + name_size], "utf-8")
                self._attachments[name] = (at, length)
            case Opcode.CHUNK:
                first, last, whole, _, name = _CHUNK.unpack_from(self._view, at)
                data = at + _CHUNK.size + name + 8
                self._chunks.append(_Chunk(first, last, data, at + length - data, whole, {}))
            case Opcode.MESSAGE_INDEX if self._chunks:
                channel_id, _ = _INDEX.unpack_from(self._view, at)
                self._chunks[-1].index[channel_id] = at

    def _index(self, number: int, channel: int) -> list[tuple[int, int]]:
        """The times of a channel's messages in a chunk, and where they begin in it."""
        at = self._chunks[number].index.get(channel)
        if at is None:
            return self._entries(number).get(channel, [])
        _, size = _INDEX.unpack_from(self._view, at)
        begin = at + _INDEX.size
        words = self._view[begin : begin + size].cast("Q")
        return sorted(zip(words[::2], words[1::2], strict=True), key=lambda one: one[0])

    def _entries(self, number: int) -> dict[int, list[tuple[int, int]]]:
        """The same of all channels, from the chunk itself."""
        data, at = self._unpacked(number), 0
        found: dict[int, list[tuple[int, int]]] = {}
        while at + _MESSAGE.size <= len(data):
            _, length, channel, _, time, _ = _MESSAGE.unpack_from(data, at)
            found.setdefault(channel, []).append((time, at))
            at += _RECORD.size + length
        return {channel: sorted(entries, key=lambda one: one[0]) for channel, entries in found.items()}

    def _body(self, number: int, offset: int) -> bytes:
        data = self._unpack(number)
        _, length = _RECORD.unpack_from(data, offset)
        return data[offset + _MESSAGE.size : offset + _RECORD.size + length]

    def _unpacked(self, number: int) -> bytes:
        chunk = self._chunks[number]
        packed = self._view[chunk.at : chunk.at + chunk.packed]
        return zstandard.ZstdDecompressor().decompress(packed, max_output_size=chunk.size)

    def _stream(self, at: int, size: int) -> ReadDataStream:
        return ReadDataStream(BytesIO(self._view[at : at + size]))
