"""The scribe: writes a recording from what it is told and from the memory in which variables lie (law 29).

In virtual time it sits beside the clock; in wall time it is a process of its own (`host.scribe_process`), so that
neither a slow disk nor compression stands between two jobs.
"""

from collections.abc import Callable
from typing import Any, BinaryIO

from msgspec import Struct, msgpack

from onika.record import foxglove, said, value
from onika.record.run import END
from onika.record.writer import Writer
from onika.ring.slots import Ring
from onika.words.shape import Shape

FLUSHED_EVERY_NS = 500_000_000
"""What is not written so long is lost where everything is killed."""


class Variable(Struct, frozen=True):
    """Where a variable lies in the table of its subsystem."""

    name: str
    shape: str
    unit: str
    offset: int


class Start(Struct, frozen=True, tag=True):
    """The run begins, at this time of the machine's clock."""

    at_ns: int


class Meet(Struct, frozen=True, tag=True):
    """Variables that have come; the memory of the table comes with the first ones of a subsystem."""

    subsystem: str
    variables: tuple[Variable, ...]


class Tell(Struct, frozen=True, tag=True):
    """Something was said: a message as it is to stand there."""

    topic: str
    at_ns: int
    body: bytes


class Show(Struct, frozen=True, tag=True):
    """What a world consists of."""

    world: str
    shapes: tuple[dict[str, Any], ...]


class Pose(Struct, frozen=True, tag=True):
    """Where the bodies of a world are, and what shines."""

    world: str
    at_ns: int
    rows: bytes
    lit: tuple[str, ...]


class Finish(Struct, frozen=True, tag=True):
    """The run is over; how it ended, and what was not told for want of room."""

    words: dict[str, str]
    untold: int = 0


Order = Start | Meet | Tell | Show | Pose | Finish
encode = msgpack.Encoder().encode
decode = msgpack.Decoder(Order).decode


class Scribe:
    """Raises OSError where the file cannot take it."""

    def __init__(self, stream: BinaryIO, writer: Writer) -> None:
        self._stream = stream
        self._writer = writer
        self._lookers: list[Callable[[int], None]] = []
        self._shapes: dict[str, tuple[dict[str, Any], ...]] = {}
        self._lit: dict[str, tuple[str, ...]] = {}
        self._flush_at = FLUSHED_EVERY_NS
        self.missed = 0
        """Values that were written over before anybody looked."""
        self.is_finished = False

    def take(self, order: Order, memory: memoryview | None = None) -> None:
        """Write it down; variables need the memory in which they lie."""
        match order:
            case Meet() if memory is not None:
                self._lookers += [self._looker(order.subsystem, one, memory) for one in order.variables]
            case Tell():
                is_event = order.topic == said.EVENTS
                title = said.HAPPENED if is_event else said.WANTED
                schema = said.HAPPENED_SCHEMA if is_event else said.WANTED_SCHEMA
                self._writer.message(self._writer.channel(order.topic, title, schema), order.at_ns, order.body)
            case Show():
                self._shapes[order.world] = order.shapes
                self._writer.attach(said.shapes(order.world), "application/json", said.encode(order.shapes))
                self._draw(order.world, 0, ())
            case Pose():
                self._pose(order)
            case Finish():
                self._finish(order)

    def look(self, now: int) -> None:
        """Write down what has changed in the variables since the last call."""
        for look in self._lookers:
            look(now)
        if now >= self._flush_at:
            self._flush_at = now + FLUSHED_EVERY_NS
            self.flush()

    def flush(self) -> None:
        """Let everything out."""
        self._writer.flush()
        self._stream.flush()

    def _finish(self, order: Finish) -> None:
        self._writer.flush()
        self._writer.note(END, {**order.words, "missed": str(self.missed), "untold": str(order.untold)})
        self._writer.finish()
        self._stream.flush()
        self.is_finished = True

    def _pose(self, order: Pose) -> None:
        if self._lit.get(order.world) != order.lit and order.world in self._shapes:
            self._draw(order.world, order.at_ns, order.lit)
        topic = said.frames(order.world)
        channel = self._writer.channel(topic, foxglove.FRAMES, foxglove.FRAMES_SCHEMA, {"world": order.world})
        self._writer.message(channel, order.at_ns, foxglove.frames(order.world, order.at_ns, order.rows))

    def _draw(self, world: str, at_ns: int, lit: tuple[str, ...]) -> None:
        self._lit[world] = lit
        words = {"world": world, "lit": ""}
        channel = self._writer.channel(said.scene(world), foxglove.SCENE, foxglove.SCENE_SCHEMA, words)
        self._writer.message(channel, at_ns, foxglove.scene(world, at_ns, self._shapes[world], lit))

    def _looker(self, subsystem: str, one: Variable, memory: memoryview) -> Callable[[int], None]:
        """A function that writes down a variable where it has changed; fast where nothing was written."""
        shape = Shape.parse(one.shape)
        ring = Ring(memory, one.offset, shape.size)
        words, since, encoded = ring.words, ring.since, value.encoder(shape)
        about = {"subsystem": subsystem, "name": one.name, "type": one.shape, "unit": one.unit}
        schema = (value.title(shape, one.unit), value.schema(shape, one.unit))
        channel = self._writer.channel(said.variable(subsystem, one.name), *schema, about)
        message = self._writer.message
        seen, last, before = 0, b"", -1

        def look(now: int) -> None:
            nonlocal seen, last, before
            if words[0] == seen:
                before = now
                return
            count, values = since(seen)
            if count - seen != len(values):
                if count < seen:  # the entry was made anew
                    count, values = since(0)
                else:
                    self.missed += count - seen - len(values)
            seen = count
            apart = (now - before) // len(values) if before >= 0 and values else 0
            at = now - apart * (len(values) - 1)
            for data in values:
                if data != last:
                    last = data
                    message(channel, at, encoded(data))
                at += apart
            before = now

        return look
