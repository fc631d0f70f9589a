"""The hub of all browsers that look at one environment: what one does, all see."""

import asyncio
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, Protocol

import msgspec

from onika import __version__
from onika.desk.environment.environment import ActAnswer, Environment
from onika.desk.environment.outcome.outcome import Done
from onika.link.caller import Role
from onika.web.access.act_rights import refusal
from onika.web.access.entrance import OWNER, Visitor
from onika.web.outbox import Outbox
from onika.wire import act, page
from onika.words.reason import NOTHING, Reason

_REMEMBERED = 200
"""Lines of the log that a browser is told when it comes."""


class WatchedValues(Protocol):
    """Whatever has the newest values of the running system."""

    def watch(self, variables: frozenset[str], worlds: frozenset[str], figures: bool, hz: float) -> None:
        """What somebody wants to see from now on, variables as `DOC/NAME`."""
        ...

    def frame(self) -> page.Frame | None:
        """What has come since the last call; None: nothing."""
        ...


class BrowserClient:
    """One browser; `ended` is set when it has to go."""

    def __init__(self, name: str, visitor: Visitor, snapshot: Callable[[], bytes]) -> None:
        self.name = name
        self.visitor = visitor
        self.ended = asyncio.Event()
        self.outbox = Outbox(snapshot)
        self.watch = act.Watch()


class Hub:
    """Brings acts to the environment, and its answers, patches, lines and frames to the browsers.

    clock   seconds since 1970
    may     why a visitor may not do an act; empty: he may
    """

    def __init__(
        self,
        environment: Environment,
        watched: WatchedValues,
        clock: Callable[[], float] = time.time,
        may: Callable[[Visitor, act.AnyAct], Reason] = refusal,
    ) -> None:
        self._clock = clock
        self._may = may
        self.denials: list[Callable[[Visitor, act.AnyAct], None]] = []
        """Told of each act that a visitor's role may not do."""
        self.limits: list[Callable[[Visitor, act.AnyAct], Reason]] = []
        """Say why a visitor may not do an act although his role may; empty: he may."""
        self._environment = environment
        self._watched = watched
        self._clients: list[BrowserClient] = []
        self._came = 0
        self._remembered: deque[bytes] = deque(maxlen=_REMEMBERED)
        environment.listeners.append(self)

    @property
    def is_watching(self) -> bool:
        """Whether anybody wants frames."""
        return any(client.watch.variables or client.watch.worlds or client.watch.figures for client in self._clients)

    @property
    def sessions(self) -> frozenset[str]:
        """The sessions of those who are here."""
        return frozenset(client.visitor.session for client in self._clients)

    @property
    def visitors(self) -> tuple[Visitor, ...]:
        """Those who are here, once for each page."""
        return tuple(client.visitor for client in self._clients)

    def come(self, visitor: Visitor = OWNER) -> BrowserClient:
        """A browser comes in; the first it is sent is a snapshot."""
        self._came += 1
        name = f"{visitor.user or 'browser'} {self._came}"
        client = BrowserClient(name, visitor, lambda: self._snapshot(client))
        for message in self._remembered:
            client.outbox.put(message)
        self._clients.append(client)
        self._count()
        return client

    def end(self, session: str) -> None:
        """Whoever is here by this session has to go."""
        for client in self._clients:
            if session and client.visitor.session == session:
                client.ended.set()

    def visitor(self, name: str) -> Visitor | None:
        """Who the browser of this name belongs to; None: it is none that is here."""
        return next((client.visitor for client in self._clients if client.name == name), None)

    def leave(self, client: BrowserClient) -> None:
        """A browser is gone."""
        self._clients.remove(client)
        self._rewatch()
        self._count()

    def take(self, client: BrowserClient, body: str | bytes) -> None:
        """Carry out what a browser sends; what is no act, or not for him who sends it, is refused."""
        if client.ended.is_set():
            return
        try:
            ordered = page.decode(body)
        except ValueError as error:
            reason = Reason.of("desk.no_act", why=Reason.plain(str(error)))
            client.outbox.put(page.encode(page.Refused(page.number_of(body), reason)))
            return
        why = self._may(client.visitor, ordered.act) or self._limited(client.visitor, ordered.act)
        if why:
            client.outbox.put(page.encode(page.Refused(ordered.cid, why)))
            for denial in self.denials:
                denial(client.visitor, ordered.act)
            return
        if isinstance(ordered.act, act.Watch):
            client.watch = ordered.act
            self._rewatch()
            client.outbox.put(page.encode(page.Ok(ordered.cid, self._environment.revision)))
            return
        self._environment.do(ordered.act, client.name, lambda given: self._answer(client, ordered.cid, given))

    def patch(self, patch: page.Patch) -> None:
        """Something has changed: all are told, in words made once."""
        message = page.encode(patch)
        for client in self._clients:
            client.outbox.patch(message)

    def remember(self, says: Iterable[page.Say]) -> None:
        """Lines that everybody who comes is shown."""
        self._remembered.extend(page.encode(self._stamped(message)) for message in says)

    def say(self, message: page.Say) -> None:
        """Something is worth a line; whoever comes later reads it in the log."""
        line = page.encode(self._stamped(message))
        self._remembered.append(line)
        for client in self._clients:
            client.outbox.put(line)

    def pump(self) -> None:
        """Bring the newest values to those who watch them."""
        frame = self._watched.frame()
        if frame is None:
            return
        made: dict[tuple[Any, ...], bytes] = {}
        for client in self._clients:
            wish = client.watch
            if not (wish.variables or wish.worlds or wish.figures):
                continue
            key = (wish.variables, wish.worlds, wish.figures)
            if key not in made:
                made[key] = _part(frame, wish)
            if made[key]:
                client.outbox.frame(made[key])

    def _answer(self, client: BrowserClient, cid: int, given: ActAnswer) -> None:
        revision = self._environment.revision
        no = given.no
        message = (
            page.Ok(cid, revision, given.value)
            if no is None
            else page.Refused(cid, no.reason, no.remedies, dict(no.fields))
        )
        client.outbox.put(page.encode(message))

    def _limited(self, visitor: Visitor, command: act.AnyAct) -> Reason:
        return next(filter(None, (limit(visitor, command) for limit in self.limits)), NOTHING)

    def _snapshot(self, client: BrowserClient) -> bytes:
        environment, visitor = self._environment, client.visitor
        role = "" if visitor.role is Role.OWNER and not visitor.user else visitor.role.word
        return page.encode(
            page.Snapshot(environment.revision, environment.tree, __version__, client.name, visitor.user, role)
        )

    def _stamped(self, message: page.Say) -> page.Say:
        """With the time: a page tells what is new from what it is only reminded of."""
        if message.at_s:
            return message
        return msgspec.structs.replace(message, at_s=self._clock())

    def _rewatch(self) -> None:
        wishes = [client.watch for client in self._clients]
        variables = frozenset(name for wish in wishes for name in wish.variables)
        worlds = frozenset(name for wish in wishes for name in wish.worlds)
        fastest = max((wish.hz for wish in wishes), default=0.0)
        self._watched.watch(variables, worlds, any(wish.figures for wish in wishes), fastest)

    def _count(self) -> None:
        self._environment.become(lambda model: Done(replace(model, people=len(self._clients))))


def _part(frame: page.Frame, wish: act.Watch) -> bytes:
    """What one browser wants of a frame; empty where nothing of it has come."""
    wanted = frozenset(wish.variables)
    values = {name: value for name, value in frame.values.items() if name in wanted}
    poses = {name: frame.poses[name] for name in wish.worlds if name in frame.poses}
    figures = frame.figures if wish.figures else {}
    if not (values or poses or figures):
        return b""
    return page.encode(page.Frame(frame.at_s, values, figures, poses))
