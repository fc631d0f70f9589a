"""The processing units of wall time, a process each; one may be added, or started anew, while others work (law 30).

All of them see the same memory. A unit that comes later is shown what there is before it is told anything else.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from onika.host.sandbox.sandboxes import BegunSandbox, Sandboxes
from onika.host.units import rtpu
from onika.host.units.supervisor import Supervised, Supervisor
from onika.ring.begin_words import BeginWords
from onika.ring.segment import Segment
from onika.runtime import command
from onika.words.reason import NOTHING, Reason, reason_of

START_NS = 30_000_000_000
"""So long a unit that is added may take until it is up; to import big libraries takes a few seconds."""
_MODULE = "onika.host.units.rtpu"

Answer = Callable[[Reason], None]
"""Is told why a unit did not come up; nothing: it has."""


@dataclass(slots=True)
class _UnitStart:
    """A unit that is not up yet, and who waits for it."""

    answer: Answer
    until_ns: int


class UnitProcesses:
    """Units by name. After a stop all of them are stopped, also one that is added then (law 27)."""

    def __init__(self, supervisor: Supervisor, names: Iterable[str]) -> None:
        self._supervisor = supervisor
        self._shared: dict[str, Segment] = {}
        self._is_stopped = False
        self._starts: dict[str, _UnitStart] = {}
        self._sandboxes = Sandboxes(with_fifo=supervisor.with_fifo)
        self._given: list[BegunSandbox] = []
        """What is on its way to units."""
        self._processes = {name: self._launch(name) for name in sorted(names)}

    @property
    def starting(self) -> tuple[str, ...]:
        """The units that were added and are not up yet: their trouble is nobody else's."""
        return tuple(self._starts)

    def send(self, name: str, order: command.Command) -> None:
        """Give a unit a command; raises ValueError where a task needs a sandbox and there is none."""
        spawn = order.spawn if isinstance(order, command.Swap) else order
        if isinstance(spawn, command.Spawn) and spawn.is_sandboxed:
            self._give_sandbox(name, spawn)
        self._processes[name].post.send(rtpu.encode(order))

    def begin_words(self, name: str) -> BeginWords:
        """By which a unit is let begin at an agreed time."""
        return self._processes[name].heartbeat.begin_words

    def send_all(self, order: command.Command) -> None:
        """Give every unit that lives a command."""
        for process in self._living():
            process.post.send(rtpu.encode(order))

    def share(self, name: str, segment: Segment) -> None:
        """Let the units see this memory, in place of any old one of this name."""
        self._shared[name] = segment
        for process in self._living():
            process.post.send(rtpu.encode(rtpu.Share(name)), (segment.fd,))

    def unshare(self, name: str) -> None:
        """The memory of this name is not used any more."""
        self._shared.pop(name, None)
        for process in self._living():
            process.post.send(rtpu.encode(rtpu.Unshare(name)))

    def stop(self) -> None:
        """Everything off and every drive in hold, latched."""
        self._is_stopped = True
        self.send_all(command.Stop())

    def reset(self) -> None:
        """Motion is allowed again; nothing moves by itself."""
        self._is_stopped = False
        self.send_all(command.Reset())

    def add(self, name: str, now_ns: int, answer: Answer) -> None:
        """Launch a unit, in place of a lost one of this name; answered when it is up, or cannot be."""
        try:
            process = self._launch(name)
        except OSError as refused:
            answer(reason_of(refused))
            return
        self._processes[name] = process
        self._starts[name] = _UnitStart(answer, now_ns + START_NS)
        for shared, segment in self._shared.items():
            process.post.send(rtpu.encode(rtpu.Share(shared)), (segment.fd,))
        if self._is_stopped:
            self.send(name, command.Stop())

    def close(self) -> None:
        """End what was begun for them."""
        self._sandboxes.close()

    def answer_starts(self, now_ns: int) -> None:
        """Whoever waits for a unit is answered when it is up; one that takes too long is ended."""
        self._look_after_sandboxes()
        for name, start in list(self._starts.items()):
            process = self._processes[name]
            if process.is_up:
                del self._starts[name]
                start.answer(NOTHING)
            elif now_ns >= start.until_ns:
                process.is_lost = True
                process.end()
                self.fail_start(process, Reason.of("host.not_up_in_time", seconds=START_NS * 1e-9))

    def fail_start(self, process: Supervised, reason: Reason) -> bool:
        """Whether this process was only starting: then who waits for it is answered, and nothing else is lost."""
        start = self._starts.pop(process.name, None)
        if start is None:
            return False
        start.answer(Reason.of("host.unit_not_started", name=process.title, why=reason))
        return True

    def _give_sandbox(self, name: str, spawn: command.Spawn) -> None:
        sandbox = self._sandboxes.begin(spawn, name)
        self._given.append(sandbox)
        given = rtpu.GiveSandbox(spawn.subsystem, spawn.task)
        self._processes[name].post.send(rtpu.encode(given), sandbox.descriptors)
        self._look_after_sandboxes()

    def _look_after_sandboxes(self) -> None:
        """What was given away is closed here when it was sent; those of units that are gone end."""
        if self._given and not any(process.post.is_waiting for process in self._living()):
            for sandbox in self._given:
                sandbox.close()
            self._given.clear()
        for name, process in self._processes.items():
            if process.is_lost:
                self._sandboxes.end_of(name)
        self._sandboxes.bury()

    def _living(self) -> list[Supervised]:
        return [process for process in self._processes.values() if not process.is_lost]

    def _launch(self, name: str) -> Supervised:
        title = Reason.of("host.processing_unit", name=name)
        return self._supervisor.launch(name, title, _MODULE, ("--name", name), has_modules=True)
