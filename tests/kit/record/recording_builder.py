"""A recording for tests, written by hand: a run of one flow, what was said and what its variables were.

builder = RecordingBuilder(path)
builder.variable("X", "double", (0.0, 1.0), (0.5, 2.0))
builder.tell(0.1, event.Began(0, 0, 1, "go", 0.1))
reader = builder.end()
"""

from pathlib import Path
from typing import Any

import numpy as np

from kit.plans.plan_builder import action
from kit.worlds.rail_world import rail_tasks
from onika.record import topics, value
from onika.record.reader import Reader
from onika.record.run import BLACK_BOX, END, RunRecord
from onika.record.writer import Writer
from onika.wire import event, request
from onika.words.shape import Shape


def run(seed: int = 3, **other: Any) -> RunRecord:
    """A run of two actions in flow0."""
    goals = [action("mass", "servo", arguments=goal) for goal in ("1.0", "2.0")]
    prepare = request.Prepare(rail_tasks().plan(goals), ())
    settings = {"is_virtual": True, "is_fresh": True, **other}
    return RunRecord(prepare, request.Begin(seed=seed), ("rt0",), began="2026-01-02T03:04:05+00:00", **settings)


class RecordingBuilder:
    """Times are seconds; of a black box `held_s` says from when to when it holds everything."""

    def __init__(
        self, path: Path, recorded: RunRecord | None = None, held_s: tuple[float, float] | None = None
    ) -> None:
        self.path = path
        self._stream = path.open("wb")
        self._writer = Writer(self._stream)
        if held_s is not None:
            begin, end = (str(_ns(at_s)) for at_s in held_s)
            self._writer.note(BLACK_BOX, {"version": "1", "from_ns": begin, "to_ns": end})
        recorded = recorded or run()
        recorded.write(self._writer)
        self.plan = recorded.prepare.plan

    def variable(self, name: str, type_: str, *course: tuple[float, Any], unit: str = "", home: str = "flow0") -> None:
        """A variable and its values."""
        shape = Shape.parse(type_)
        about = {"subsystem": home, "name": name, "type": type_, "unit": unit}
        schema = (value.title(shape, unit), value.schema(shape, unit))
        channel = self._writer.channel(topics.variable(home, name), *schema, about)
        for at_s, message in course:
            data = message if isinstance(message, bytes) else np.array(message, dtype=shape.type.code).tobytes()
            self._writer.message(channel, _ns(at_s), value.encoder(shape)([data])[0])

    def note(self, name: str, words: dict[str, str]) -> None:
        """Words that stand beside the run."""
        self._writer.note(name, words)

    def tell(self, at_s: float, message: event.Event, subsystem: str = "flow0") -> None:
        """An event."""
        body = topics.encode(topics.EventRecord(subsystem, message))
        self._writer.message(
            self._writer.channel(topics.EVENTS, topics.HAPPENED, topics.HAPPENED_SCHEMA), _ns(at_s), body
        )

    def ask(self, at_s: float, message: request.Request, turn: int = 1) -> None:
        """Something that was asked."""
        topic = topics.ANSWERS if isinstance(message, request.Reply) else topics.COMMANDS
        channel = self._writer.channel(topic, topics.WANTED, topics.WANTED_SCHEMA)
        self._writer.message(channel, _ns(at_s), topics.encode(topics.RequestRecord(turn, "me", message)))

    def show(self, at_s: float, topic: str, title: str, schema: bytes, body: bytes) -> None:
        """Any other message."""
        self._writer.message(self._writer.channel(topic, title, schema), _ns(at_s), body)

    def attach(self, name: str, data: bytes) -> None:
        """A file within the file."""
        self._writer.attach(name, "application/json", data)

    def cut(self) -> Reader:
        """Leave it as a killed runtime does."""
        self._writer.flush()
        self._stream.close()
        return Reader(self.path)

    def end(self, **words: str) -> Reader:
        """Finish it; how the run ended."""
        self._writer.flush()
        self._writer.note(END, words)
        self._writer.finish()
        self._stream.close()
        return Reader(self.path)


def _ns(at_s: float) -> int:
    return round(at_s * 1e9)
