"""A client of a runtime program without a link between them: requests in, replies and events out, in virtual time."""

from collections import deque
from collections.abc import Callable

from kit.worlds.mass_world import MassWorld
from kit.worlds.rail_world import YardLoading
from onika.host.program import RuntimeProgram
from onika.host.sessions.leases import Leases, SessionSilence
from onika.host.sessions.request_server import SessionRequest
from onika.host.units.virtual import VirtualDriver
from onika.link.caller import Role
from onika.wire import event, holding, live, reading, request
from onika.wire.runtime_standing import Standing
from onika.wire.world_source import WorldSource

SECOND = 1_000_000_000


class OpenGate:
    """A gate for any number of sessions, each of which hears everything it attends."""

    def __init__(self) -> None:
        self.waiting: deque[SessionRequest] = deque()
        self.replies: dict[int, request.Response] = {}
        self.events: list[event.Event] = []
        self.deliveries: list[tuple[str, str, event.Event]] = []
        """Each event with the subsystem whose listeners it is for, and a session that gets it in any case."""
        self.attends: dict[str, tuple[str, ...]] = {}
        self.shown: list[tuple[str, str, reading.Reading]] = []
        self.gone: list[str] = []
        self.known: dict[str, Role] = {}
        self.addresses: tuple[str, ...] = ()
        self.libraries: tuple[str, ...] = ()
        self.launcher = ""
        self.silent: dict[str, int] = {}
        """By session: for how long it has not been heard, in ns."""
        self.ears: list[Callable[[event.Event, str], None]] = []

    def requests(self) -> list[SessionRequest]:
        """What was asked."""
        calls = list(self.waiting)
        self.waiting.clear()
        self.known |= {call.session: call.role for call in calls if call.session not in self.known}
        return calls

    def sessions(self) -> tuple[holding.SessionStanding, ...]:
        """All that have asked something and are not gone."""
        return tuple(holding.SessionStanding(name, role.word) for name, role in self.known.items())

    def deaf_ns(self) -> int:
        """Everybody is heard as soon as he speaks."""
        return 0

    def hearing(self, session: str) -> SessionSilence | None:
        """For how long a session has not been heard, as a test says it; None: its lease never ends."""
        silent_ns = self.silent.get(session)
        return None if silent_ns is None else SessionSilence(silent_ns)

    def reply(self, ticket: int, response: request.Response) -> None:
        """Each request is answered once."""
        if ticket in self.replies:
            raise KeyError(f"request {ticket} is answered already")
        request.decode_response(request.encode(response))  # it has to travel
        self.replies[ticket] = response

    def tell(self, message: event.Event, subsystem: str = "", session: str = "") -> None:
        """Say an event."""
        event.decode(event.encode(message))
        self.events.append(message)
        self.deliveries.append((subsystem, session, message))
        for ear in self.ears:
            ear(message, subsystem)

    def overhear(self, ear: Callable[[event.Event, str], None]) -> None:
        """From now on this one hears everything too."""
        self.ears.append(ear)

    def leave(self, ear: Callable[[event.Event, str], None]) -> None:
        """It hears nothing more."""
        self.ears.remove(ear)

    def attend(self, session: str, subsystems: tuple[str, ...]) -> None:
        """What a session hears."""
        self.attends[session] = subsystems

    def show(self, session: str, key: str, body: bytes) -> None:
        """A reading."""
        self.shown.append((session, key, reading.decode(body)))

    def lost(self) -> list[str]:
        """The sessions that are gone."""
        gone, self.gone = self.gone, []
        for session in gone:
            self.known.pop(session, None)
        return gone


def _mass_world(_name: str, files: WorldSource | None = None) -> MassWorld:
    """Whatever is asked for, and whatever files come for it."""
    return MassWorld()


class DirectClient:
    """Asks the program and lets it work."""

    def __init__(self, rtpus: tuple[str, ...] = ("rt0",)) -> None:
        self._rtpus = rtpus
        self.server = OpenGate()
        self.driver = VirtualDriver(rtpus, self.server.tell, worlds=_mass_world)
        self.program = RuntimeProgram(self.server, self.driver, YardLoading(), rtpus)  # type: ignore[arg-type]
        self._count = 0

    def go_on_renewed(self) -> None:
        """The program was renewed: a new one goes on with what was asked."""
        renewal = self.program.renewal
        assert renewal is not None
        self.program.leave()
        self.driver.close()
        self.driver = VirtualDriver(self._rtpus, self.server.tell, worlds=_mass_world)
        self.program = RuntimeProgram(self.server, self.driver, YardLoading(), self._rtpus)  # type: ignore[arg-type]
        self.program.go_on(renewal)

    def lease(self, length_ns: int) -> None:
        """From now on holders are there only as long as the gate hears them; a late machine excuses nobody."""
        self.program.leases = Leases(self.program.authority, self.server.hearing, length_ns, clock=lambda: 0)

    def send(self, message: request.Request, session: str = "me") -> int:
        """Ask, and look for the answer later; its ticket."""
        self._count += 1
        self.server.waiting.append(SessionRequest(self._count, session, Role.OWNER, message))
        self.program.serve()
        return self._count

    def ask(self, message: request.Request, session: str = "me") -> request.Response:
        """Ask and let the program work until it answers."""
        ticket = self.send(message, session)
        for _ in range(10_000):
            if ticket in self.server.replies:
                return self.server.replies[ticket]
            self.program.advance(SECOND)
        raise TimeoutError(f"no answer to {message}")

    def change(self, subsystem: str = "s0", session: str = "me", **what: object) -> str:
        """Change a subsystem and wait for the outcome; why it came to nothing, or nothing."""
        answer = self.ask(live.Change(subsystem, **what), session)  # type: ignore[arg-type]
        return self.outcome(answer)

    def outcome(self, answer: request.Response) -> str:
        """What became of an accepted request; of any other its reason."""
        if isinstance(answer, request.Refused):
            return str(answer.reason)
        if isinstance(answer, request.Prepared):
            return "; ".join(str(fault.reason) for fault in answer.faults)
        if not isinstance(answer, live.Accepted):
            raise TypeError(f"expected Accepted, found {answer}")
        self.program.advance(SECOND)
        ends = [
            message
            for message in self.server.events
            if isinstance(message, event.Edited) and message.number == answer.number
        ]
        if len(ends) != 1:
            raise RuntimeError(f"expected one outcome of {answer.number}, found {ends}")
        return str(ends[0].cause)

    def states(self, subsystem: str = "s0") -> dict[str, str]:
        """The tasks of a subsystem and their states."""
        standing = self.ask(live.Survey())
        if not isinstance(standing, Standing):
            raise TypeError(str(standing))
        subsystems = [
            standing_subsystem for standing_subsystem in standing.subsystems if standing_subsystem.name == subsystem
        ]
        return {task.task.name: task.state for held in subsystems for task in held.tasks}

    def values(self, *names: str, subsystem: str = "s0") -> dict[str, object]:
        """Variables as they stand."""
        answer = self.ask(live.Read(subsystem, names))
        if not isinstance(answer, live.Values):
            raise TypeError(str(answer))
        return answer.values

    def of(self, kind: type) -> list[event.Event]:
        """What was told of one kind."""
        return [message for message in self.server.events if isinstance(message, kind)]

    def to_the_end(self) -> event.Result | None:
        """Let everything go on until nothing happens by itself."""
        while self.program.advance(SECOND):
            pass
        return self.result

    @property
    def result(self) -> event.Result | None:
        """The last thing told, if it is a result."""
        last = self.server.events[-1] if self.server.events else None
        return last if isinstance(last, event.Result) else None
