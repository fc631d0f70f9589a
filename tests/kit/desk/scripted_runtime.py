"""A runtime that says what a test has written down, and a watcher of a run that keeps what it is told."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, ClassVar, NamedTuple, Self

from onika.wire import event, request, steer
from onika.words.fault import Fault
from onika.words.reason import Reason


class After(NamedTuple):
    """An event that comes once this was asked."""

    message: request.Request
    happening: event.Event


Happening = event.Event | Exception | After | Callable[[], None]


class ScriptedRuntime:
    """Says what it is told to; keeps what it was asked."""

    script: ClassVar[Sequence[Happening]] = ()
    faults: ClassVar[tuple[request.FaultText, ...]] = ()
    refuses: ClassVar[str] = ""
    begins: ClassVar[request.Response] = request.Done()
    snapshots: ClassVar[request.Response] = request.Worlds({"boxes": b"drawn"})
    positions: ClassVar[tuple[steer.Position, ...]] = ()
    refusals: ClassVar[Mapping[str, Reason]] = {}
    made: ClassVar["ScriptedRuntime | None"] = None

    def __init__(
        self,
        rtpus: Sequence[str],
        is_virtual: bool,
        with_fifo: bool,
        options: Sequence[str] = (),
        has_black_box: bool = True,
        start: object = None,
    ) -> None:
        del has_black_box, start
        self.given = (rtpus, is_virtual, with_fifo)
        self.options = options
        self.requests: list[request.Request | str] = []
        self.pid = 4711
        self.left = list(self.script)
        type(self).made = self

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.requests.append("closed")

    def ask(self, message: request.Request) -> request.Response:
        """The response that the test has set for this kind of request."""
        self.requests.append(message)
        match message:
            case request.Prepare():
                if self.refuses:
                    return request.Refused(Reason.plain(self.refuses))
                return request.Prepared(self.faults, (Reason.plain("a note"),))
            case request.Begin():
                return self.begins
            case request.Snapshot():
                return self.snapshots
            case steer.Who():
                return steer.Positions(self.positions)
        reason = self.refusals.get(type(message).__name__)
        return request.Done() if reason is None else request.Refused(reason)

    def events(self, _timeout_s: float) -> Iterator[event.Event]:
        """The next of the script, if its time has come."""
        following = self.left[0]
        if isinstance(following, After):
            if following.message not in self.requests:
                return
            following = following.happening
        del self.left[0]
        if isinstance(following, Exception):
            raise following
        if callable(following):
            following()
        else:
            yield following

    def printed(self) -> str:
        """What it has printed last."""
        return "it printed this"

    def black_box(self) -> str:
        """Where its last seconds are."""
        return "/state/last.mcap"


class KeepingWatcher:
    """Watches a run and keeps what it is told."""

    can_steer = False
    looks_now = False
    wanted: Sequence[str] = ()

    def __init__(self) -> None:
        self.seen: list[Any] = []

    def begins(self, prepared: Any, runtime_pid: int) -> None:
        """Keep which run it is."""
        self.seen.append((prepared.name, runtime_pid))

    def happens(self, message: event.Event) -> None:
        """Keep what happens."""
        self.seen.append(message)

    def answer(self, message: event.Asked) -> str | None:
        """An answer to any question."""
        return f"an answer for {message.task}"

    def wishes(self) -> Sequence[str]:
        """What was typed since the last time."""
        taken, self.wanted = self.wanted, ()
        return taken

    def looks(self) -> bool:
        """Whether it wants to know where the flows are."""
        return self.looks_now

    def placed(self, positions: Sequence[steer.Position]) -> None:
        """Keep where the flows are."""
        self.seen.append(positions)

    def steered(self, line: str, faults: Sequence[Fault], positions: Sequence[steer.Position]) -> None:
        """Keep what became of a line."""
        self.seen.append((line, [str(fault.reason) for fault in faults], positions))
