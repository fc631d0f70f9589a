"""The recording of a run whose flows are carried out at several runtimes: one file, written by who joins them (X05).

It has one clock: everything stands at the time at which it was heard here, since the run was begun here; so it comes as
much late as the line takes. What an event itself says of its time is that of its own runtime, since it began there.
"""

import os
from collections.abc import Mapping
from contextlib import suppress
from datetime import UTC, datetime
from time import monotonic_ns

from msgspec import DecodeError, ValidationError, structs

from onika.desk.plan.compile import rtpus_of
from onika.record import told_value, topics, value
from onika.record.run import END, RunRecord, ending
from onika.record.writer import Writer
from onika.wire import event, reading, request
from onika.wire.plan import Plan
from onika.words.reason import NOTHING, Reason
from onika.words.shape import Shape
from onika.words.system_error import system_reason

_FLUSHED_NS = 500_000_000


class JointRecording:
    """Raises OSError where the file cannot be begun; later that is its `reason`, and the run goes on.

    stations   what the runtime of each subsystem is called
    """

    def __init__(self, prepare: request.Prepare, begin: request.Begin, stations: Mapping[str, str]) -> None:
        self.reason: Reason = NOTHING
        self._plan: Plan = prepare.plan
        self._stream = open(begin.record, "xb")  # noqa: SIM115, PTH123 - it stays open for the run
        self._writer = Writer(self._stream)
        self._began = monotonic_ns()
        self._flushed = self._began
        self._shapes: dict[str, tuple[int, Shape]] = {}
        now = datetime.now(UTC).isoformat(timespec="milliseconds")
        bare, units = structs.replace(begin, record=""), tuple(rtpus_of(self._plan))
        RunRecord(prepare, bare, units, is_virtual=False, is_fresh=False, began=now, stations=dict(stations)).write(
            self._writer
        )

    def hear(self, message: event.Event) -> None:
        """Write down what has happened, with the numbers and names of the whole run."""
        if isinstance(message, event.Result):
            self._finish(ending(message))
        elif not isinstance(message, event.Stood):
            body = topics.encode(topics.EventRecord(self._subsystem(message), message))
            self._say(topics.EVENTS, topics.HAPPENED, topics.HAPPENED_SCHEMA, body)

    def read(self, readings: Mapping[str, bytes]) -> None:
        """Write down what variables hold, by `SUBSYSTEM/NAME`."""
        for key, body in readings.items():
            with suppress(DecodeError, ValidationError):
                taken = reading.decode(body)
                if isinstance(taken, reading.Variable) and not self.reason:
                    self._take(key, taken.value)

    def close(self, cause: Reason = NOTHING) -> None:
        """End it, where no result has; why the run has none."""
        why = str(cause or Reason.of("desk.record_left"))
        self._finish({"completed": "no", "cause": why, "hash": "", "outside": ""})

    def _take(self, key: str, newest: object) -> None:
        shape = told_value.shape_of(newest)
        if shape is None:
            return
        home, _, name = key.rpartition("/")
        if key not in self._shapes:
            about = {"subsystem": home, "name": name, "type": str(shape), "unit": ""}
            channel = self._writer.channel(topics.variable(home, name), value.title(shape), value.schema(shape), about)
            self._shapes[key] = (channel, shape)
        channel, first = self._shapes[key]
        if shape.dims == first.dims:  # a task with other dimensions came in its place
            self._write(channel, told_value.encoded(newest, first))

    def _subsystem(self, message: event.Event) -> str:
        """Whom it is about."""
        if isinstance(message, event.Began | event.Done):
            return self._plan.flows[message.flow].subsystem
        return str(getattr(message, "subsystem", ""))

    def _say(self, topic: str, title: str, schema: bytes, body: bytes) -> None:
        if not self.reason:
            self._write(self._writer.channel(topic, title, schema), body)

    def _write(self, channel: int, body: bytes) -> None:
        now = monotonic_ns()
        try:
            self._writer.message(channel, now - self._began, body)
            if now - self._flushed >= _FLUSHED_NS:
                self._flushed = now
                self._writer.flush()
                self._stream.flush()
        except OSError as wrong:
            self.reason = system_reason(wrong)

    def _finish(self, words: dict[str, str]) -> None:
        if self._stream.closed:
            return
        try:
            if not self.reason:
                self._writer.flush()
                self._writer.note(END, {**words, "missed": "0", "untold": "0"})
                self._writer.finish()
                self._stream.flush()
                os.fsync(self._stream.fileno())
        except OSError as wrong:
            self.reason = system_reason(wrong)
        with suppress(OSError):  # of what could not be written that was told
            self._stream.close()
