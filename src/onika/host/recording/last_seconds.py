"""The last seconds of a run, in bounded memory; written as an ordinary recording where it ends badly (requirement X05).

What costs is left for then: values are kept as they lie in memory, events as they are told. Of the time before only
what still holds is known: the value of each variable, the state of each task, flow and drive.
"""

from bisect import bisect_left
from collections import deque
from collections.abc import Collection, Mapping
from typing import BinaryIO, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from onika.host.recording.recorded_variable import VariablePlace
from onika.host.recording.variable_trace import VariableTrace
from onika.record import topics, value
from onika.record.run import BLACK_BOX, END, RunRecord
from onika.record.writer import Writer

LASTS_NS = 30_000_000_000
MOST_BYTES = 48 * 2**20
"""What values may take; of a run that writes more the last seconds are fewer."""
MOST_EVENTS = 20_000
MOST_EVENT_BYTES = 8 * 2**20
_TIDIED_EVERY_NS = 1_000_000_000
_CHUNK_NS = 500_000_000
"""Of a recording: so much of the run stands together."""


class TracedVariables(Struct, frozen=True, tag=True):
    """Variables that have come; the memory of the table comes with the first ones of a subsystem."""

    subsystem: str
    variables: tuple[VariablePlace, ...]
    gone: tuple[str, ...] = ()
    """Those of before that are no more: something else may lie there now."""


class TracedEvent(Struct, frozen=True, tag=True):
    """Something was told or asked. `standing` names what it holds for, until the next one says otherwise; empty: it
    passes."""

    topic: str
    at_ns: int
    body: bytes
    standing: str = ""


class _SeriesPart(NamedTuple):
    channel: int
    times: list[int]
    bodies: list[bytes]


class LastSeconds:
    """Times are nanoseconds since the run's start."""

    def __init__(self, lasts_ns: int = LASTS_NS, most_bytes: int = MOST_BYTES) -> None:
        self._lasts_ns = lasts_ns
        self._most_bytes = most_bytes
        self._traces: list[VariableTrace] = []
        self._counts: list[int] = []
        self._ended: list[VariableTrace] = []
        """Of variables that are gone; what was written to them is kept as long as anything."""
        self._events: deque[TracedEvent] = deque()
        self._event_bytes = 0
        self._standing: dict[str, TracedEvent] = {}
        self._looked_at = -1
        self._tidy_at = _TIDIED_EVERY_NS
        self._begin = 0
        """From here on everything is kept."""

    def meet(self, order: TracedVariables, memory: memoryview) -> None:
        """Variables that have come, and those that are gone."""
        if order.gone:
            self._end_traces(order.subsystem, order.gone)
        for place in order.variables:
            self._traces.append(VariableTrace(order.subsystem, place, memory))
            self._counts.append(0)

    def note(self, traced: TracedEvent) -> None:
        """Something was told or asked."""
        self._events.append(traced)
        self._event_bytes += len(traced.body)
        while len(self._events) > MOST_EVENTS or self._event_bytes > MOST_EVENT_BYTES:
            self._let_pass()

    def look(self, now: int) -> None:
        """Keep what has changed in the variables since the last call."""
        counts = [trace.words[0] for trace in self._traces]
        if counts != self._counts:
            before = self._looked_at
            for number, count in enumerate(counts):
                if count != self._counts[number] and not self._traces[number].take(now, before):
                    counts[number] = self._counts[number]  # it is looked at again
            self._counts = counts
        self._looked_at = now
        if now >= self._tidy_at:
            self._tidy_at = now + _TIDIED_EVERY_NS
            self._tidy(now)

    @property
    def size(self) -> int:
        """Bytes of values and events that are kept."""
        return self._value_bytes + self._event_bytes

    def write(self, stream: BinaryIO, run: RunRecord, words: Mapping[str, str]) -> None:
        """Write it as a recording; `words` are those of its end. Raises OSError."""
        writer, begin = Writer(stream), self._begin
        writer.note(BLACK_BOX, {"version": "1", "from_ns": str(begin), "to_ns": str(max(self._looked_at, begin))})
        replace(run, is_fresh=run.is_fresh and not begin).write(writer)
        series = [self._series(writer, trace) for trace in (*self._ended_alike(), *self._traces)]
        events = sorted(self._kept_events(), key=lambda traced: traced.at_ns)
        last = max([self._looked_at, begin, *(traced.at_ns for traced in events[-1:])])
        for at in range(begin, last + 1, _CHUNK_NS):
            for part in series:
                first, end = bisect_left(part.times, at), bisect_left(part.times, at + _CHUNK_NS)
                if first < end:
                    writer.messages(part.channel, part.times[first:end], part.bodies[first:end])
            while events and events[0].at_ns < at + _CHUNK_NS:
                self._write_event(writer, events.pop(0))
            writer.flush()
        missed = sum(trace.missed for trace in (*self._ended, *self._traces))
        writer.note(END, {**words, "missed": str(missed), "untold": "0"})
        writer.finish()

    # Inner

    @property
    def _value_bytes(self) -> int:
        return sum(trace.size for trace in (*self._ended, *self._traces))

    def _end_traces(self, subsystem: str, names: Collection[str]) -> None:
        """These are not looked at any more."""
        kept = [not (trace.subsystem == subsystem and trace.place.name in names) for trace in self._traces]
        self._ended += [trace for trace, is_kept in zip(self._traces, kept, strict=True) if not is_kept]
        self._counts = [count for count, is_kept in zip(self._counts, kept, strict=True) if is_kept]
        self._traces = [trace for trace, is_kept in zip(self._traces, kept, strict=True) if is_kept]

    def _ended_alike(self) -> list[VariableTrace]:
        """Those that are gone; of a variable that is there again with another type only what it is now is told."""
        types = {(trace.subsystem, trace.place.name): _type(trace) for trace in (*self._ended, *self._traces)}
        return [trace for trace in self._ended if types[trace.subsystem, trace.place.name] == _type(trace)]

    def _tidy(self, now: int) -> None:
        """Let go of what is older than it has to be, or takes too much room."""
        begin = max(self._begin, now - self._lasts_ns)
        self._forget(begin)
        while begin < now and self._value_bytes > self._most_bytes:
            begin += _TIDIED_EVERY_NS
            self._forget(begin)

    def _forget(self, begin: int) -> None:
        self._begin = begin
        for trace in (*self._ended, *self._traces):
            trace.forget(begin)
        self._ended = [trace for trace in self._ended if trace.newest_at >= begin]
        while self._events and self._events[0].at_ns < begin:
            self._let_pass()

    def _let_pass(self) -> None:
        """The oldest event goes; what it says may still hold."""
        traced = self._events.popleft()
        self._event_bytes -= len(traced.body)
        if traced.standing:
            self._standing[traced.standing] = traced

    def _kept_events(self) -> list[TracedEvent]:
        """What still held at the begin is said there, in the order in which it was told."""
        standing = sorted(self._standing.values(), key=lambda traced: traced.at_ns)
        return [replace(traced, at_ns=max(traced.at_ns, self._begin)) for traced in (*standing, *self._events)]

    def _series(self, writer: Writer, trace: VariableTrace) -> _SeriesPart:
        place, shape = trace.place, trace.shape
        about = {"subsystem": trace.subsystem, "name": place.name, "type": place.shape, "unit": place.unit}
        topic = topics.variable(trace.subsystem, place.name)
        channel = writer.channel(topic, value.title(shape, place.unit), value.schema(shape, place.unit), about)
        times, values = trace.values(self._begin)
        return _SeriesPart(channel, times, value.encoder(shape)(values) if values else [])

    def _write_event(self, writer: Writer, traced: TracedEvent) -> None:
        is_event = traced.topic == topics.EVENTS
        title = topics.HAPPENED if is_event else topics.WANTED
        schema = topics.HAPPENED_SCHEMA if is_event else topics.WANTED_SCHEMA
        writer.message(writer.channel(traced.topic, title, schema), traced.at_ns, traced.body)


def _type(trace: VariableTrace) -> tuple[str, str]:
    return trace.place.shape, trace.place.unit
