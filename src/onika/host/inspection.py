"""What sessions see of a runtime: what there is, figures, variables, and what they watch at a bounded rate."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import isnan
from typing import Protocol

from onika.host.sessions.request_server import Gate
from onika.host.subsystems.subsystem_registry import Stage
from onika.model.lifecycle import State
from onika.runtime import news
from onika.runtime.bus import Poses
from onika.runtime.integrity import Accessor, check
from onika.runtime.subsystem import Member
from onika.runtime.table import plain
from onika.wire import live, reading, request

_FASTEST_HZ = 60.0
_SLOWEST_HZ = 0.1

Answer = Callable[[request.Response], None]


class Seen(Protocol):
    """The driver, as far as it can be looked at."""

    @property
    def now(self) -> int:
        """The runtime's time in ns."""
        ...

    @property
    def is_virtual(self) -> bool:
        """Whether time is virtual."""
        ...

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds that are open."""
        ...

    def scene(self, world: str) -> dict[str, object] | None:
        """What an open world consists of."""
        ...

    def poses(self, world: str) -> Poses | None:
        """The newest poses of an open world, their time and what shines; see `bus.Poses`."""
        ...


@dataclass(slots=True)
class _Watch:
    """What one session watches."""

    period_ns: int
    readings: tuple[str, ...]
    worlds: tuple[str, ...]
    next_ns: int = 0
    counts: dict[str, int] = field(default_factory=dict)


class Look:
    """Answers every question that changes nothing."""

    def __init__(self, stage: Stage, seen: Seen, gate: Gate, rtpus: tuple[str, ...]) -> None:
        self._stage = stage
        self._seen = seen
        self._gate = gate
        self._rtpus = rtpus
        self._watches: dict[str, _Watch] = {}

    def answer(self, session: str, asked: request.Request, is_stopped: bool) -> request.Response:
        """Answer at once."""
        match asked:
            case live.Survey():
                return self._standing(is_stopped)
            case live.Read():
                return self._values(asked)
            case live.Check():
                return self._findings(asked.subsystem)
            case live.Attend():
                return self._attend(session, asked)
            case live.Scene():
                scene = self._seen.scene(asked.world)
                return live.Scenery(scene) if scene is not None else request.Refused(f"no world {asked.world} is open")
        return request.Refused(f"a runtime does not answer {type(asked).__name__}")

    def status(self, answer: Answer) -> None:
        """The figures of all tasks, as soon as every unit has answered."""

        def told(came: dict[str, news.Statuses]) -> None:
            figures = tuple(_figure(one.rtpu, status) for one in came.values() for status in one.tasks)
            loads = {name: one.load for name, one in came.items()}
            answer(live.Figures(figures, loads, tuple(_overloads(came))))

        self._stage.roll.call(told)

    def forget(self, session: str) -> None:
        """A session is gone."""
        self._watches.pop(session, None)

    def show(self, wall_ns: int) -> None:
        """Show every session what it watches, if it is time: the newest values, and only what has changed."""
        for session, watch in self._watches.items():
            if wall_ns >= watch.next_ns:
                watch.next_ns = wall_ns + watch.period_ns
                self._show(session, watch, self._seen.now)

    def due_ns(self, wall_ns: int) -> int | None:
        """How long until `show` has something to do."""
        times = [watch.next_ns for watch in self._watches.values() if watch.readings or watch.worlds]
        return max(0, min(times) - wall_ns) if times else None

    def _show(self, session: str, watch: _Watch, now: int) -> None:
        for pattern in watch.readings:
            home, _, wanted = pattern.rpartition("/")
            table = self._stage.tables.get(home)
            names = [] if table is None else list(table.entries) if wanted == "*" else [wanted]
            for name in names:
                self._show_variable(session, watch, home, name, now)
        for world in watch.worlds:
            poses = self._seen.poses(world)
            if poses is not None and watch.counts.get(f"world:{world}") != poses[0]:
                watch.counts[f"world:{world}"] = poses[0]
                self._gate.show(session, f"world:{world}", reading.encode(reading.Poses(*poses)))

    def _show_variable(self, session: str, watch: _Watch, home: str, name: str, now: int) -> None:
        table = self._stage.tables[home]
        if name not in table.entries:
            return
        key, count = f"{home}/{name}", table.ring(name).count
        if watch.counts.get(key) != count:
            watch.counts[key] = count
            body = reading.Variable(now, count, plain(table.value(name)))
            self._gate.show(session, key, reading.encode(body))

    def _attend(self, session: str, asked: live.Attend) -> request.Response:
        if isnan(asked.hz):
            return request.Refused("expected how often to show readings in hertz, found nan")
        self._gate.attend(session, asked.subsystems)
        hz = min(max(asked.hz, _SLOWEST_HZ), _FASTEST_HZ)
        self._watches[session] = _Watch(round(1e9 / hz), asked.readings, asked.worlds)
        return request.Done()

    def _values(self, asked: live.Read) -> request.Response:
        table = self._stage.tables.get(asked.subsystem)
        if table is None:
            return request.Refused(f"there is no subsystem {asked.subsystem}")
        unknown = [name for name in asked.names if name not in table.entries]
        if unknown:
            return request.Refused(f"no task of {asked.subsystem} reads or writes {', '.join(unknown)}")
        names = asked.names or tuple(sorted(table.entries))
        values = {name: plain(value) for name, value in table.values(names).items()}
        types = {name: str(table.entries[name].shape) for name in names}
        return live.Values(values, self._seen.now * 1e-9, types)

    def _findings(self, subsystem: str) -> request.Response:
        table = self._stage.tables.get(subsystem)
        if table is None:
            return request.Refused(f"there is no subsystem {subsystem}")
        found = check(table, [_accessor(one) for one in self._stage.members(subsystem).values()])
        return live.Findings(tuple(str(one) for one in found))

    def _standing(self, is_stopped: bool) -> live.Standing:
        names = [*self._stage.live, *(name for one in self._stage.performances for name in one.names)]
        subsystems = tuple(self._subsystem(name) for name in sorted(set(names)))
        lost, loads = self._stage.lost_units, self._stage.roll.loads
        rtpus = tuple(live.RtpuStanding(name, name in lost, loads.get(name, 0.0)) for name in self._rtpus)
        seen = self._seen
        return live.Standing(subsystems, rtpus, seen.worlds, seen.is_virtual, is_stopped, seen.now * 1e-9)

    def _subsystem(self, name: str) -> live.SubsystemStanding:
        performance = self._stage.performance_in(name)
        by_hand = self._stage.live.get(name)
        members = self._stage.members(name)
        if performance is not None:
            tasks = tuple(_task(one, one.state is State.ON, None, "") for one in members.values())
            asks, on_loss = performance.runner.questions(name), performance.on_loss
            return live.SubsystemStanding(name, performance.session, performance.application, tasks, asks, on_loss)
        if by_hand is None:
            return live.SubsystemStanding(name, "", "", ())
        tasks = tuple(
            _task(one, by_hand.desired.is_on(task), by_hand.desired.rate(task), by_hand.reason(task))
            for task, one in members.items()
        )
        return live.SubsystemStanding(name, by_hand.holder, "", tasks, by_hand.executor.questions)


def _task(member: Member, is_wanted_on: bool, rate: float | None, reason: str) -> live.TaskStanding:
    task = member.wired.task
    return live.TaskStanding(
        task, member.state.value, is_wanted_on, member.rtpu, task.frequency if rate is None else rate, reason
    )


def _accessor(member: Member) -> Accessor:
    wired = member.wired
    writes = frozenset((*wired.outconst, *wired.outvar))
    return Accessor(wired.name, member.rtpu, writes, frozenset((*wired.inconst, *wired.invar)))


def _figure(rtpu: str, one: news.TaskStatus) -> live.TaskFigure:
    return live.TaskFigure(
        subsystem=one.subsystem,
        task=one.task,
        rmod=one.module,
        rtpu=rtpu,
        tid=one.tid,
        type=one.letter,
        crit=one.crit,
        state=one.state,
        cycle=one.cycle,
        miss=one.miss,
        ref_hz=one.reference_hz,
        mez_hz=one.measured_hz,
        ptime_s=one.profiled_s,
        total_ms=one.total_us * 1e-3,
        tick_ms=one.tick_ms,
        least_use=one.use(one.least_us),
        most_use=one.use(one.most_us),
        mean_use=one.use(one.mean_us),
        least_ms=one.least_us * 1e-3,
        most_ms=one.most_us * 1e-3,
        mean_ms=one.mean_us * 1e-3,
        warn=one.warn,
    )


def _overloads(came: Mapping[str, news.Statuses]) -> list[str]:
    """Units whose tasks that are ON ask for more time than there is."""
    found = []
    for rtpu, statuses in came.items():
        use = sum(one.use(one.mean_us) for one in statuses.tasks if one.state == State.ON.value)
        if use > 1.0:
            found.append(f"the tasks that are ON take {use:.2f} of the time of unit {rtpu}: cycles are missed")
    return found
