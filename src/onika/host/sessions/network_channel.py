"""The network channel of a runtime is opened and closed by its owner while it runs (requirement A16, §E.1).

A runtime is closed until somebody opens it. Nothing waits for the process that listens: whoever asked is answered when
it does, or cannot.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import monotonic_ns
from typing import Protocol

from msgspec.structs import replace

from onika.files.state.access import STRANGERS, WRITING, Access, guard
from onika.host.processes.process_socket import ProcessSocket
from onika.host.sessions.listen_options import ListenerSettings, ListenOptions, judge
from onika.host.sessions.listener_process import ListenerProcess
from onika.host.sessions.request_backlog import Answer
from onika.host.sessions.request_server import ConnectionSource
from onika.host.sessions.users import User
from onika.link.address import is_near, split_host
from onika.link.caller import Role
from onika.link.token import digest, new_token
from onika.wire import holding, request
from onika.words.reason import Reason, reason_of

_START_NS = 20_000_000_000
_END_NS = 2_000_000_000
GUEST = "guest"
_ROLES = {role.word: role for role in Role}


class ChannelServer(Protocol):
    """Who serves those that come in over the channel."""

    addresses: tuple[str, ...]

    @property
    def launcher(self) -> str:
        """The session of the program that launched this runtime; empty: nobody did."""
        ...

    def welcome(self, listener: ConnectionSource) -> None:
        """From now on take in who comes there."""
        ...

    def dismiss(self, reason: Reason) -> None:
        """Nobody comes any more, and whoever came is told good-bye."""
        ...


@dataclass(slots=True)
class _Opening:
    """A listener that does not listen yet, and who waits for it."""

    listener: ListenerProcess
    answer: Answer
    listening: holding.Listening
    until_ns: int


class NetworkChannel:
    """The one place at which others reach a runtime."""

    def __init__(
        self,
        server: ChannelServer,
        launch: Callable[[ListenerSettings], ListenerProcess] = ListenerProcess,
        clock: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._server = server
        self._launch = launch
        self._clock = clock
        self._listener: ListenerProcess | None = None
        self._opening: _Opening | None = None
        self._ending: list[tuple[ListenerProcess, int]] = []

    def adopt(self, listener: ListenerProcess) -> None:
        """It was opened at the start, and may be closed like any other."""
        self._listener = listener

    def readers(self) -> list[ProcessSocket]:
        """What to wait for: a listener that is about to listen."""
        return [] if self._opening is None else [self._opening.listener.post]

    def due_ns(self) -> int | None:
        """How long until `serve` has something to do by itself."""
        dues = [until for _, until in self._ending] + ([] if self._opening is None else [self._opening.until_ns])
        return max(0, min(dues) - self._clock()) if dues else None

    def open(self, message: holding.Listen, answer: Answer) -> None:
        """Begin to listen; answered when that is so."""
        if self._opening is not None or self._server.addresses:
            answer(request.Refused(Reason.of("host.listens_already", addresses=self._server.addresses)))
            return
        prepared = _prepared(message)
        if isinstance(prepared, Reason):
            answer(request.Refused(prepared))
            return
        settings, listening = prepared
        if self._listener is not None:
            self._end(self._listener)  # it ended by itself
        self._listener = None
        try:
            listener = self._launch(settings)
        except OSError as wrong:
            answer(request.Refused(reason_of(wrong)))
            return
        self._opening = _Opening(listener, answer, listening, self._clock() + _START_NS)

    def close(self, answer: Answer) -> None:
        """Let nobody in any more, and say good-bye to those who are."""
        if self._listener is None or not self._server.addresses:
            answer(request.Refused(Reason.of("host.listens_nowhere")))
        elif not self._server.launcher:
            answer(request.Refused(Reason.of("host.only_way_in", addresses=self._server.addresses)))
        else:
            answer(request.Done())
            self._server.dismiss(Reason.of("host.channel_closed"))
            self._end(self._listener)
            self._listener = None

    def serve(self) -> None:
        """Whether it listens by now, or has ended."""
        self._ending = [(listener, until) for listener, until in self._ending if not self._is_over(listener, until)]
        opening = self._opening
        if opening is None:
            return
        try:
            is_open = opening.listener.look()
            if not is_open and self._clock() >= opening.until_ns:
                raise OSError(Reason.of("host.porter_not_started"))
        except OSError as wrong:
            self._opening = None
            self._end(opening.listener)
            opening.answer(request.Refused(reason_of(wrong)))
            return
        if is_open:
            self._opening, self._listener = None, opening.listener
            self._server.welcome(opening.listener)
            opening.answer(replace(opening.listening, addresses=(opening.listener.address,)))

    def finish(self) -> None:
        """The runtime ends: so does whoever listens for it."""
        listeners = [listener for listener, _ in self._ending]
        listeners += [] if self._opening is None else [self._opening.listener]
        for listener in listeners:
            listener.close()

    def _end(self, listener: ListenerProcess) -> None:
        listener.leave()
        self._ending.append((listener, self._clock() + _END_NS))

    def _is_over(self, listener: ListenerProcess, until_ns: int) -> bool:
        if listener.is_gone:
            return True
        if self._clock() < until_ns:
            return False
        listener.close()
        return True


def _prepared(message: holding.Listen) -> tuple[ListenerSettings, holding.Listening] | Reason:
    """What the listener needs, and what is told to whoever asked; or all that is missing for it."""
    if message.role not in _ROLES:
        return Reason.of("host.role_unknown", roles=tuple(_ROLES), role=message.role)
    named = ((message.users, WRITING), (message.certificate, WRITING), (message.key, STRANGERS))
    report = guard([Access(Path(path), denied) for path, denied in named if path])
    if report.refused:
        return Reason.of("host.channel_not_opened", why=report.refused)
    options = ListenOptions(message.place, message.certificate, message.key, message.users, message.names)
    settings, faults, token_at = judge(options)
    if settings is None:
        return Reason.of("host.channel_not_opened", why=tuple(fault.reason for fault in faults))
    if not is_near(split_host(message.place)[0]):
        return settings, holding.Listening(())  # there only users with names are let in
    token = new_token()
    guest = User(GUEST, _ROLES[message.role], digest(token))
    settings = replace(settings, users=(*settings.users, guest))
    return settings, holding.Listening((), token_at, token, message.role)
