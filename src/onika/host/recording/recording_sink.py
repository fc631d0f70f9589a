"""The recording sink writes a recording from what it is told and from the memory in which variables lie (law 29).

In virtual time it sits beside the clock; in wall time it is a process of its own (`recording_process`), so that
neither a slow disk nor compression stands between two jobs.
"""

import os
import stat
from collections.abc import Collection
from itertools import compress
from operator import not_
from typing import Any, BinaryIO

from msgspec import Struct, msgpack

from onika.host.recording.recorded_variable import VariablePlace, VariableRecorder
from onika.host.units.pose_stream import WorldPoses
from onika.record import foxglove, topics
from onika.record.run import END, RunRecord
from onika.record.writer import Writer
from onika.words.reason import Reason

FLUSHED_EVERY_NS = 500_000_000
"""What is not written so long is lost where everything is killed."""


class BeginRecording(Struct, frozen=True, tag=True):
    """The run begins, at this time of the machine's clock."""

    at_ns: int


class AddVariables(Struct, frozen=True, tag=True):
    """Variables that have come; the memory of the table comes with the first ones of a subsystem."""

    subsystem: str
    variables: tuple[VariablePlace, ...]
    gone: tuple[str, ...] = ()
    """Those of before that are no more: something else may lie there now."""
    is_late: bool = False
    """Whether they were written before the recording began; of that only what they are now belongs to it."""


class DescribeRecording(Struct, frozen=True, tag=True):
    """What is recorded consists of something else now; the description comes beside."""


class AddMessage(Struct, frozen=True, tag=True):
    """Something was said: a message as it is to stand there."""

    topic: str
    at_ns: int
    body: bytes


class AddScene(Struct, frozen=True, tag=True):
    """What a world consists of."""

    world: str
    shapes: tuple[dict[str, Any], ...]


class FinishRecording(Struct, frozen=True, tag=True):
    """The run is over; how it ended, and what was not told for want of room."""

    words: dict[str, str]
    untold: int = 0


Order = BeginRecording | AddVariables | DescribeRecording | AddMessage | AddScene | WorldPoses | FinishRecording
encode = msgpack.Encoder().encode
decode = msgpack.Decoder(Order).decode


class RecordingSink:
    """Raises OSError where the file cannot take it, or is not the one any more that was begun."""

    def __init__(self, stream: BinaryIO, writer: Writer) -> None:
        self._stream = stream
        self._writer = writer
        self._watched: list[VariableRecorder] = []
        self._counts: list[int] = []
        self._long: list[VariableRecorder] = []
        self._looked_at = -1
        self._turn = 0
        self._written = 0
        self._missed_of_gone = 0
        self._shapes: dict[str, tuple[dict[str, Any], ...]] = {}
        self._lit: dict[str, tuple[str, ...]] = {}
        self._flush_at = FLUSHED_EVERY_NS
        self.untold = 0
        """Poses that did not come here for want of room."""
        self.is_finished = False

    def take(self, order: Order, memory: memoryview | None = None) -> None:
        """Write it down; variables need the memory in which they lie."""
        match order:
            case AddVariables() if memory is not None:
                self._leave(order.subsystem, order.gone)
                some = [
                    VariableRecorder(order.subsystem, variable, memory, self._writer, is_late=order.is_late)
                    for variable in order.variables
                ]
                self._watched += some
                self._counts += [0] * len(some)
                self._long += [watched for watched in some if watched.is_long]
            case AddMessage():
                is_event = order.topic == topics.EVENTS
                title = topics.HAPPENED if is_event else topics.WANTED
                schema = topics.HAPPENED_SCHEMA if is_event else topics.WANTED_SCHEMA
                self._writer.message(self._writer.channel(order.topic, title, schema), order.at_ns, order.body)
            case AddScene():
                self._shapes[order.world] = order.shapes
                self._writer.attach(topics.shapes(order.world), "application/json", topics.encode(order.shapes))
                self._draw(order.world, 0, ())
            case WorldPoses():
                self._pose(order)
            case FinishRecording():
                self._finish(order)

    def describe(self, run: RunRecord) -> None:
        """From now on this is what is recorded; what was said of it before counts no more."""
        run.write(self._writer)

    def look(self, now: int) -> None:
        """Write down what has changed in the variables since the last call."""
        counts = [watched.words[0] for watched in self._watched]
        if counts != self._counts:
            for watched, count, before in zip(self._watched, counts, self._counts, strict=True):
                if count != before:
                    watched.take(now, self._looked_at)
            self._counts = counts
        self._looked_at = now
        if now >= self._flush_at:
            self._flush_at = now + FLUSHED_EVERY_NS
            self.flush()
        elif self._watched:  # one at each look, so that none takes long
            self._turn = (self._turn + 1) % len(self._watched)
            self._watched[self._turn].settle()

    @property
    def is_in_no_hurry(self) -> bool:
        """Whether the entries of all variables keep so many values that every second look is enough."""
        return not any(watched.is_short_lived for watched in self._long)

    @property
    def missed(self) -> int:
        """Values that were written over before anybody looked."""
        return self._missed_of_gone + sum(watched.missed for watched in self._watched)

    def flush(self) -> None:
        """Let everything out."""
        self._judge()
        self._settle()
        self._writer.flush()
        self._out()

    def _leave(self, subsystem: str, names: Collection[str]) -> None:
        """These variables are not looked at any more; what was taken of them is written down."""
        if not names:
            return
        kept = [not (watched.subsystem == subsystem and watched.name in names) for watched in self._watched]
        for watched in compress(self._watched, map(not_, kept)):
            watched.settle()
            self._missed_of_gone += watched.missed
        self._counts = list(compress(self._counts, kept))
        self._watched = list(compress(self._watched, kept))
        self._long = [watched for watched in self._watched if watched.is_long]

    def _settle(self) -> None:
        for watched in self._watched:
            watched.settle()

    def _out(self) -> None:
        self._stream.flush()
        self._written = self._writer.written

    def _judge(self) -> None:
        """Whether the file still is what it was: somebody may delete it, write over it, or cut it."""
        about = os.fstat(self._stream.fileno())
        if not about.st_nlink:
            raise OSError(Reason.of("host.file_deleted"))
        if stat.S_ISREG(about.st_mode) and about.st_size < self._written:
            raise OSError(Reason.of("host.file_cut"))

    def _finish(self, order: FinishRecording) -> None:
        self._judge()
        self._settle()
        self._writer.flush()
        self._writer.note(END, {**order.words, "missed": str(self.missed), "untold": str(order.untold + self.untold)})
        self._writer.finish()
        self._out()
        self.is_finished = True

    def _pose(self, order: WorldPoses) -> None:
        self.untold += order.left_out
        if self._lit.get(order.world) != order.lit and order.world in self._shapes:
            self._draw(order.world, order.at_ns, order.lit)
        topic = topics.frames(order.world)
        channel = self._writer.channel(topic, foxglove.FRAMES, foxglove.FRAMES_SCHEMA, {"world": order.world})
        self._writer.message(channel, order.at_ns, foxglove.frames(order.world, order.at_ns, order.rows))

    def _draw(self, world: str, at_ns: int, lit: tuple[str, ...]) -> None:
        self._lit[world] = lit
        words = {"world": world, "lit": ""}
        channel = self._writer.channel(topics.scene(world), foxglove.SCENE, foxglove.SCENE_SCHEMA, words)
        self._writer.message(channel, at_ns, foxglove.scene(world, at_ns, self._shapes[world], lit))
