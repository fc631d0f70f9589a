"""A runtime as the environment sees it: a child process behind a link, asked and listened to (house decision 1)."""

from collections import deque
from collections.abc import Iterator
from time import monotonic_ns
from types import TracebackType

from onika.link.connection import Connection
from onika.link.happening import Happening, Signalled, Turned
from onika.link.launcher import Child, launch
from onika.link.lost import Cause, LinkLost
from onika.link.terms import CHILD
from onika.wire import event, request

_PATIENCE_S = 60.0


class Runtime:
    """A runtime that was launched; ends with the `with` block, and so do all its processes."""

    def __init__(self, rtpus: tuple[str, ...], is_virtual: bool, with_fifo: bool = True) -> None:
        words = [word for name in rtpus for word in ("--rtpu", name)]
        if is_virtual:
            words.append("--virtual")
        if not with_fifo:
            words.append("--no-fifo")
        self._child: Child = launch(words)
        self._connection = Connection(self._child.carrier, monotonic_ns, CHILD)
        self._news: deque[Happening] = deque()

    def __enter__(self) -> "Runtime":
        try:
            self._connection.open(_PATIENCE_S)
        except (LinkLost, TimeoutError) as lost:
            raise self._with_tail(lost) from None
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._connection.close(timeout_s=0.2)
        self._child.close()

    @property
    def pid(self) -> int:
        """The process id of the runtime program."""
        return self._child.pid

    def ask(self, asked: request.Request) -> request.Response:
        """Ask and wait for the response; raises LinkLost with what the runtime printed last, or TimeoutError."""
        try:
            body = self._connection.request(request.encode(asked), _PATIENCE_S, once=True, urgent=True)
        except LinkLost as lost:
            raise self._with_tail(lost) from None
        response: request.Response = request.decode_response(body)
        return response

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """The events since the last call, at least one within the time-out or none; raises LinkLost at the end."""
        if not self._news:
            self._news += self._connection.poll(timeout_s)
        while self._news:  # one by one: whoever stops listening hears the others next time
            happening = self._news.popleft()
            if isinstance(happening, Signalled):
                yield event.decode(happening.body)
            elif isinstance(happening, Turned) and happening.lost is not None:
                raise self._with_tail(happening.lost)

    def printed(self) -> str:
        """What the runtime and its processes printed last."""
        return self._child.tail()

    def _with_tail(self, lost: LinkLost | TimeoutError) -> LinkLost:
        cause = lost.cause if isinstance(lost, LinkLost) else Cause.SILENT
        code = self._child.wait(0.5)
        how = "" if code is None else f"; it {_ended(code)}"
        printed = self._child.tail().strip()
        said = f"; it printed last: {printed[-2000:]}" if printed else ""
        return LinkLost(cause, f"the runtime is gone: {lost}{how}{said}")


def _ended(code: int) -> str:
    return f"was killed by signal {-code}" if code < 0 else f"ended with code {code}"
