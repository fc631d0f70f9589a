"""Looks into a recording: the state of the run at any instant, and curves of its variables (requirement X05).

with Review(path) as review:
    review.flows                      # names, actions and when each was carried out
    review.at(12.5).variables         # {"flow0/LAMP": 1, …}
    review.course("flow0/Q_MEZ", 0.0, 60.0, 800)
"""

from bisect import bisect_right
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any

import msgspec

from onika.desk.run.flow_status import FlowStatus
from onika.desk.run.recorded_run import events_of
from onika.record import downsampled, foxglove, topics as said
from onika.record.black_box_span import BlackBoxSpan
from onika.record.reader import Reader
from onika.record.run import END, RunRecord
from onika.record.series import Series
from onika.wire import event, request
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Interval:
    """An action that was carried out, to its end or until it was left; the last one of a run cut short has no end."""

    action: int
    name: str
    begin_s: float
    end_s: float | None
    is_done: bool = False


@dataclass(slots=True)
class ReviewedFlow:
    """One flow of the run."""

    subsystem: str
    actions: tuple[str, ...]
    intervals: list[Interval] = field(default_factory=list)
    statuses: list[tuple[float, FlowStatus]] = field(default_factory=lambda: [(float("-inf"), FlowStatus(""))])
    """Since when it was where."""

    def now(self, at_s: float, status: FlowStatus) -> None:
        """It is there from now on."""
        self.statuses.append((at_s, status))


@dataclass(frozen=True, slots=True)
class Instant:
    """What the run was like at one time."""

    at_s: float
    flows: dict[str, tuple[str, int]]
    """By subsystem, the flow's state and its current or last action (-1 before the first)."""
    tasks: dict[str, str]
    """By `subsystem/task`, the state."""
    drives: dict[str, str]
    variables: dict[str, Any]
    """By `subsystem/NAME`; what was not written yet is not there."""
    poses: dict[str, list[list[float]]]
    """By world, position and quaternion (w first) of each body."""


@dataclass(frozen=True, slots=True)
class DownsampledSeries:
    """One element of a variable over a stretch of time: in each of equal parts of it the least and the greatest."""

    label: str
    unit: str
    at_s: list[float]
    least: list[float]
    most: list[float]


class Review:
    """Raises ValueError where the file is no recording of a run, OSError where it cannot be read."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._reader = Reader(path)
        self.run = RunRecord.read(self._reader)
        self.is_whole = self._reader.is_whole
        """Whether the recording came to its end; else it was cut short, and ends where it was."""
        self.ending = dict(self._reader.notes.get(END, {}))
        """How the run ended, as it was noted: completed, cause, hash, seconds, missed, untold."""
        self.black_box = BlackBoxSpan.of(self._reader.notes)
        """What it holds of the run, where it is a black box."""
        self.series = Series.all_of(self._reader)
        self.events = events_of(self._reader)
        """When in ns, about which subsystem, and what."""
        self.flows = [
            ReviewedFlow(flow.subsystem, tuple(action.name for action in flow.actions))
            for flow in self.run.prepare.plan.flows
        ]
        self._tasks = _Track()
        self._drives = _Track()
        for at, subsystem, message in self.events:
            self._learn(at, subsystem, message)

    def __enter__(self) -> "Review":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Give the file back."""
        self._reader.close()

    @property
    def span_s(self) -> tuple[float, float]:
        """From when to when something was recorded, in seconds of the run."""
        first, last = self._reader.span
        return first / 1e9, last / 1e9

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds whose poses were recorded."""
        prefix, suffix = said.frames("").split("//")
        topics = [
            channel
            for channel in self._reader.channels
            if channel.startswith(prefix + "/") and channel.endswith("/" + suffix)
        ]
        return tuple(channel[len(prefix) + 1 : -len(suffix) - 1] for channel in topics)

    @property
    def commands(self) -> list[tuple[int, request.Request]]:
        """What was asked of the run, and when in ns."""
        states = []
        for topic in (said.COMMANDS, said.ANSWERS):
            for at, body in self._reader.messages(topic):
                states.append((at, said.decode_wanted(body).request))
        return states

    def at(self, at_s: float, *, with_pictures: bool = True) -> Instant:
        """Everything at one time; variables that are pictures only if they are wanted."""
        at = round(at_s * 1e9)
        values = {name: series.at(at) for name, series in self.series.items() if with_pictures or not series.is_picture}
        return Instant(
            at_s,
            {flow.subsystem: _state(flow, at_s) for flow in self.flows},
            self._tasks.at(at),
            self._drives.at(at),
            {name: value for name, value in values.items() if value is not None},
            {world: poses for world in self.worlds if (poses := self.poses(world, at_s))},
        )

    def poses(self, world: str, at_s: float) -> list[list[float]]:
        """Where the bodies of a world were; empty before they were first seen."""
        frame = self._reader.newest(said.frames(world), round(at_s * 1e9))
        return [] if frame is None else foxglove.rows(frame[1])

    def first_poses(self, world: str) -> list[list[float]]:
        """Where the bodies of a world were when they were first seen; empty where they never were."""
        frame = next(self._reader.messages(said.frames(world)), None)
        return [] if frame is None else foxglove.rows(frame[1])

    def scene(self, world: str, at_s: float) -> dict[str, Any] | None:
        """What a world consisted of, as a scene update of Foxglove."""
        update = self._reader.newest(said.scene(world), round(at_s * 1e9))
        scene: dict[str, Any] | None = None if update is None else msgspec.json.decode(update[1])
        return scene

    def shapes(self, world: str, at_s: float = 0.0) -> list[dict[str, Any]] | None:
        """What a world consisted of, as whoever draws it live is told; None: it is not in the recording."""
        kept = self._reader.attachment(said.shapes(world))
        if kept is not None:
            elements: list[dict[str, Any]] = msgspec.json.decode(kept)
            return elements
        drawn = self._reader.newest(said.scene(world), round(at_s * 1e9)) or next(
            self._reader.messages(said.scene(world)), None
        )
        return None if drawn is None else foxglove.shapes(drawn[1])

    def lit(self, world: str, at_s: float) -> list[str]:
        """The shapes of a world that shone."""
        scene = self._reader.newest(said.scene(world), round(at_s * 1e9))
        return [] if scene is None else foxglove.lit(scene[1])

    def course(self, address: str, begin_s: float, end_s: float, points: int = 800) -> list[DownsampledSeries]:
        """Each element of a variable `subsystem/NAME` in at most so many points; raises KeyError for an unknown one.

        A point tells the least and the greatest value of its part of the time, so that no peak is lost.
        """
        series = self.series[address]
        if not downsampled.is_drawn(series):
            return []
        begin, end = round(begin_s * 1e9), round(end_s * 1e9)
        return drawn(series, downsampled.parts(downsampled.samples(series, begin, end), begin, end, points))

    # Inner

    def _learn(self, at: int, subsystem: str, message: event.Event) -> None:
        match message:
            case event.Began():
                flow = self._flow(subsystem)
                _leave(flow, message.at_s)
                flow.intervals.append(Interval(message.index, message.action, message.at_s, None))
                flow.now(message.at_s, flow.statuses[-1][1].began(message))
            case event.Done():
                _leave(self._flow(subsystem), message.at_s, message.index)
            case event.Result():
                for flow in self.flows:
                    _leave(flow, message.runtime_s)
            case event.Moved():
                flow = self._flow(message.subsystem)
                flow.now(message.at_s, flow.statuses[-1][1].moved(message))
            case event.TaskState():
                self._tasks.add(f"{message.subsystem}/{message.task}", at, message.state)
            case event.Drive():
                self._drives.add(message.device, at, message.state)

    def _flow(self, subsystem: str) -> ReviewedFlow:
        flow = next((flow for flow in self.flows if flow.subsystem == subsystem), None)
        if flow is None:
            given = subsystem or Reason.of("desk.none")
            raise ValueError(Reason.of("desk.strange_flow", path=str(self.path), subsystem=given))
        return flow


class _Track:
    """States by name, each since a time."""

    def __init__(self) -> None:
        self._since: dict[str, tuple[list[int], list[str]]] = {}

    def add(self, name: str, at: int, state: str) -> None:
        times, states = self._since.setdefault(name, ([], []))
        times.append(at)
        states.append(state)

    def at(self, at: int) -> dict[str, str]:
        grouped = {}
        for name, (times, states) in self._since.items():
            place = bisect_right(times, at)
            if place:
                grouped[name] = states[place - 1]
        return grouped


def _leave(flow: ReviewedFlow, at_s: float, action: int | None = None) -> None:
    """The action that is carried out has ended, if it is this one: done, or left for another one."""
    last = flow.intervals[-1] if flow.intervals else None
    if last is not None and last.end_s is None and action in (None, last.action):
        flow.intervals[-1] = Interval(last.action, last.name, last.begin_s, at_s, is_done=action is not None)


def drawn(series: Series, parts: downsampled.Parts) -> list[DownsampledSeries]:
    """Each element of a variable, as it is drawn."""
    at_s, least, most = parts.at_s.tolist(), parts.least.T.tolist(), parts.most.T.tolist()
    return [DownsampledSeries(label, series.unit, at_s, least[k], most[k]) for k, label in enumerate(series.labels)]


def _state(flow: ReviewedFlow, at_s: float) -> tuple[str, int]:
    status = flow.statuses[bisect_right(flow.statuses, at_s, key=lambda place: place[0]) - 1][1]
    return status.state, status.action
