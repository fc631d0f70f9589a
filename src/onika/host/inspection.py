"""What sessions see of a runtime: what there is, figures, variables, and what they watch at a bounded rate."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import isnan
from typing import Any, Protocol

from onika.host.sessions.request_server import RequestServer
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.units.driver_clock import DriverClock
from onika.host.units.world_views import WorldViews
from onika.model.lifecycle import State
from onika.ring.displacement import Displacement
from onika.runtime import news
from onika.runtime.integrity import Accessor, check
from onika.runtime.subsystem import Member
from onika.runtime.table import Table, plain
from onika.wire import live, reading, request
from onika.wire.runtime_standing import RtpuStanding, Standing, SubsystemStanding, TaskStanding
from onika.words.reason import NOTHING, Reason

_FASTEST_HZ = 60.0
_SLOWEST_HZ = 0.1
_LONGEST_SHOWN = 1 << 15  # bytes of a value

Answer = Callable[[request.Response], None]


class InspectedDriver(DriverClock, Protocol):
    """The driver, as far as it can be looked at."""

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds that are open."""
        ...

    @property
    def simulated(self) -> tuple[str, ...]:
        """Those of them in which nothing outside the program moves."""
        ...

    @property
    def views(self) -> WorldViews:
        """What whoever looks sees of them."""
        ...

    def displaced(self) -> dict[str, tuple[Displacement, ...]]:
        """What does not stand where it stood at the start, by world."""
        ...


@dataclass(slots=True)
class _Watch:
    """What one session watches."""

    period_ns: int
    readings: tuple[str, ...]
    worlds: tuple[str, ...]
    next_ns: int = 0
    counts: dict[str, int] = field(default_factory=dict)


class Inspection:
    """Answers every question that changes nothing."""

    def __init__(self, subsystems: Subsystems, seen: InspectedDriver, server: RequestServer) -> None:
        self._subsystems = subsystems
        self._seen = seen
        self._server = server
        self._watches: dict[str, _Watch] = {}

    def answer(self, session: str, message: request.Request, is_stopped: bool) -> request.Response:
        """Answer at once."""
        match message:
            case live.Survey():
                return self._standing(is_stopped)
            case live.Read():
                return self._values(message)
            case live.Check():
                return self._findings(message.subsystem)
            case live.Attend():
                return self._attend(session, message)
            case live.Scene():
                scene = self._seen.views.scene(message.world)
                if scene is None:
                    return request.Refused(Reason.of("host.no_world_open", world=message.world))
                return live.Scenery(scene)
        return request.Refused(Reason.of("host.not_answered", request=type(message).__name__))

    def status(self, answer: Answer) -> None:
        """The figures of all tasks, as soon as every unit has answered."""

        def told(came: dict[str, news.Statuses]) -> None:
            figures = tuple(_figure(statuses.rtpu, status) for statuses in came.values() for status in statuses.tasks)
            loads = {name: statuses.load for name, statuses in came.items()}
            answer(live.Figures(figures, loads, tuple(_overloads(came)), self._subsystems.forecast.cycles_us))

        self._subsystems.status_poll.call(told)

    def forget(self, session: str) -> None:
        """A session is gone."""
        self._watches.pop(session, None)
        self._look()

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
            table = self._subsystems.tables.get(home)
            names = [] if table is None else list(table.entries) if wanted == "*" else [wanted]
            for name in names:
                self._show_variable(session, watch, home, name, now)
        for camera in filter(_is_camera, watch.worlds):
            picture = self._seen.views.picture(camera)
            if picture is not None and watch.counts.get(f"world:{camera}") != picture[1]:
                number, at_ns, file = picture
                watch.counts[f"world:{camera}"] = at_ns
                self._server.show(
                    session, f"world:{camera}", reading.encode(reading.CameraPicture(at_ns, number, file))
                )
        for world in watch.worlds:
            poses = self._seen.views.poses(world)
            if poses is not None and watch.counts.get(f"world:{world}") != poses[0]:
                watch.counts[f"world:{world}"] = poses[0]
                self._server.show(session, f"world:{world}", reading.encode(reading.Poses(*poses)))

    def _show_variable(self, session: str, watch: _Watch, home: str, name: str, now: int) -> None:
        table = self._subsystems.tables[home]
        if name not in table.entries:
            return
        key, count = f"{home}/{name}", table.ring(name).count
        if watch.counts.get(key) != count:
            watch.counts[key] = count
            body = reading.Variable(now, count, _shown(table, name))
            self._server.show(session, key, reading.encode(body))

    def _attend(self, session: str, message: live.Attend) -> request.Response:
        if isnan(message.hz):
            return request.Refused(Reason.of("host.hz_nan"))
        self._server.attend(session, message.subsystems)
        hz = min(max(message.hz, _SLOWEST_HZ), _FASTEST_HZ)
        self._watches[session] = _Watch(round(1e9 / hz), message.readings, message.worlds)
        self._look()
        return request.Done()

    def _look(self) -> None:
        """Cameras at which nobody looks any more may rest."""
        self._seen.views.look_only_at(
            {name for watch in self._watches.values() for name in watch.worlds if _is_camera(name)}
        )

    def _values(self, message: live.Read) -> request.Response:
        table = self._subsystems.tables.get(message.subsystem)
        if table is None:
            return request.Refused(Reason.of("host.no_subsystem", subsystem=message.subsystem))
        unknown = [name for name in message.names if name not in table.entries]
        if unknown:
            return request.Refused(Reason.of("host.not_read", subsystem=message.subsystem, names=tuple(unknown)))
        names = message.names or tuple(sorted(table.entries))
        values = {name: plain(value) for name, value in table.values(names).items()}
        types = {name: str(table.entries[name].shape) for name in names}
        return live.Values(values, self._seen.now * 1e-9, types)

    def _findings(self, subsystem: str) -> request.Response:
        table = self._subsystems.tables.get(subsystem)
        if table is None:
            return request.Refused(Reason.of("host.no_subsystem", subsystem=subsystem))
        found = check(table, [_accessor(member) for member in self._subsystems.members(subsystem).values()])
        return live.Findings(tuple(finding.reason for finding in found))

    def _standing(self, is_stopped: bool) -> Standing:
        names = [*self._subsystems.live, *(name for run in self._subsystems.runs for name in run.names)]
        subsystems = tuple(self._subsystem(name) for name in sorted(set(names)))
        lost, loads = self._subsystems.lost_units, self._subsystems.status_poll.loads
        rtpus = tuple(RtpuStanding(name, name in lost, loads.get(name, 0.0)) for name in self._subsystems.units)
        seen = self._seen
        now_s, addresses = seen.now * 1e-9, self._server.addresses
        displaced = {} if self._subsystems.runs else seen.displaced()
        facts = seen.is_virtual, is_stopped, now_s, addresses, seen.simulated, displaced
        return Standing(subsystems, rtpus, seen.worlds, *facts, self._server.libraries)

    def _subsystem(self, name: str) -> SubsystemStanding:
        run = self._subsystems.run_in(name)
        by_hand = self._subsystems.live.get(name)
        members = self._subsystems.members(name)
        if run is not None:
            claims = run.runner.claims(name)
            tasks = tuple(
                _task(member, member.state is State.ON, None, NOTHING, claims.get(task, ""))
                for task, member in members.items()
            )
            asks, on_loss = run.runner.questions(name), run.on_loss
            return SubsystemStanding(name, run.session, run.application, tasks, asks, on_loss)
        if by_hand is None:
            return SubsystemStanding(name, "", "", ())
        desired, claims = by_hand.desired, by_hand.executor.spawner.claims
        tasks = tuple(
            _task(member, desired.is_on(task), desired.rate(task), by_hand.reason(task), claims.get(task, ""))
            for task, member in members.items()
        )
        return SubsystemStanding(
            name, by_hand.holder, "", tasks, by_hand.executor.questions, recording=by_hand.recording
        )


def _is_camera(name: str) -> bool:
    """Whether a camera is meant, as `WORLD:CAMERA`, and no world."""
    return ":" in name


def _shown(table: Table, name: str) -> Any:
    """A value as it is shown; of a picture, or anything else as long, only its type."""
    shape = table.entries[name].shape
    return str(shape) if shape.size > _LONGEST_SHOWN else plain(table.value(name))


def _task(member: Member, is_wanted_on: bool, rate: float | None, reason: Reason, claims: str) -> TaskStanding:
    task = member.wired.task
    frequency = task.frequency if rate is None else rate
    return TaskStanding(task, member.state.value, is_wanted_on, member.rtpu, frequency, reason, claims)


def _accessor(member: Member) -> Accessor:
    wired = member.wired
    writes = frozenset((*wired.outconst, *wired.outvar))
    return Accessor(wired.name, member.rtpu, writes, frozenset((*wired.inconst, *wired.invar)))


def _figure(rtpu: str, task_status: news.TaskStatus) -> live.TaskFigure:
    return live.TaskFigure(
        subsystem=task_status.subsystem,
        task=task_status.task,
        rmod=task_status.module,
        rtpu=rtpu,
        tid=task_status.tid,
        type=task_status.letter,
        crit=task_status.crit,
        state=task_status.state,
        cycle=task_status.cycle,
        miss=task_status.miss,
        ref_hz=task_status.reference_hz,
        mez_hz=task_status.measured_hz,
        ptime_s=task_status.profiled_s,
        total_ms=task_status.total_us * 1e-3,
        tick_ms=task_status.tick_ms,
        least_use=task_status.use(task_status.least_us),
        most_use=task_status.use(task_status.most_us),
        mean_use=task_status.use(task_status.mean_us),
        least_ms=task_status.least_us * 1e-3,
        most_ms=task_status.most_us * 1e-3,
        mean_ms=task_status.mean_us * 1e-3,
        warn=task_status.warn,
    )


def _overloads(came: Mapping[str, news.Statuses]) -> list[Reason]:
    """Units whose tasks that are ON ask for more time than there is."""
    found = []
    for rtpu, statuses in came.items():
        use = sum(task.use(task.mean_us) for task in statuses.tasks if task.state == State.ON.value)
        if use > 1.0:
            found.append(Reason.of("host.overload", use=use, rtpu=rtpu))
    return found
