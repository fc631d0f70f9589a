"""A copy of a recording that leaves the machine: paths in it name no home (requirement X21).

Plan, events, commands and answers are rewritten; values, worlds and the sources of modules stay byte by byte, since the
plan knows the sources by their hashes. A recording that was cut short stays one.
"""

from typing import BinaryIO

from onika.record.reader import Reader
from onika.record.topics import ANSWERS, COMMANDS, EVENTS
from onika.record.writer import Writer
from onika.words.homeless import homeless

_TOLD = frozenset((EVENTS, COMMANDS, ANSWERS))
_SOURCES = "code/"


def homeless_copy(reader: Reader, stream: BinaryIO, home: str = "") -> None:
    """Write the copy; raises what reading a recording raises, and OSError."""
    writer = Writer(stream)
    for name in reader.attachments:
        content = reader.attachment(name) or b""
        is_source = name.startswith(_SOURCES)
        kind = "text/x-python" if is_source else "application/json"
        writer.attach(name, kind, content if is_source else _without_home(content, home))
    for name, words in reader.notes.items():
        writer.note(name, {key: homeless(word, home) for key, word in words.items()})
    for topic, channel in reader.channels.items():
        schema = reader.schemas[channel.schema_id]
        number = writer.channel(topic, schema.name, schema.data, channel.metadata)
        for times, bodies in reader.bodies(topic):
            kept = [_without_home(body, home) for body in bodies] if topic in _TOLD else bodies
            writer.messages(number, times, kept)
    if reader.is_whole:
        writer.finish()
    else:
        writer.flush()


def _without_home(content: bytes, home: str) -> bytes:
    return homeless(content.decode(errors="surrogateescape"), home).encode(errors="surrogateescape")
