"""The gate: the runtime's end of the link; requests in, replies and events out (house decision 7)."""

from collections.abc import Callable

from onika.link.happening import Asked
from onika.link.port import ServerPort
from onika.wire import event, request


class Gate:
    """One environment; every request gets exactly one response."""

    def __init__(self, port: ServerPort, clock: Callable[[], int]) -> None:
        self._port = port
        self._clock = clock
        self._told: list[event.Event] = []

    @property
    def is_open(self) -> bool:
        """Whether the environment is there."""
        return self._port.is_open

    def fileno(self) -> int:
        """To wait for in `select`."""
        return self._port.fileno()

    @property
    def is_waiting(self) -> bool:
        """Whether something still waits to be sent."""
        return self._port.want_write()

    def tell(self, one: event.Event) -> None:
        """Say an event: numbered, acknowledged, never lost. It goes out at the next `flush`, so that telling never
        stands between a trigger's finish and the next job."""
        self._told.append(one)

    def flush(self) -> None:
        """Send what was told."""
        if self._told:
            told, self._told = self._told, []
            now = self._clock()
            for one in told:
                self._port.signal(event.encode(one), now)

    def requests(self) -> list[tuple[int, request.Request]]:
        """What was asked since the last call, by ticket; what is no request is refused at once."""
        self.flush()
        asked = []
        for happening in self._port.service(self._clock()):
            if not isinstance(happening, Asked):
                continue
            try:
                asked.append((happening.ticket, request.decode_request(happening.body)))
            except ValueError as wrong:
                self.reply(happening.ticket, request.Refused(f"expected a request, found something else: {wrong}"))
        return asked

    def reply(self, ticket: int, response: request.Response) -> None:
        """Answer a request; what was told before goes first."""
        self.flush()
        self._port.reply(ticket, request.encode(response), self._clock())
