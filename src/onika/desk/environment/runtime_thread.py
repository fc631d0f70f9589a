"""The runtime thread: all that goes to a runtime, launched here or elsewhere, and all that comes from it."""

import select
import socket
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from threading import Thread
from time import monotonic
from typing import Protocol

from onika.desk.environment.environment import Environment
from onika.desk.environment.frames import FrameBuffer
from onika.desk.environment.outcome.outcome import Done, Order, RequiredRuntime, Simulator
from onika.desk.environment.reconcile import runtime_loss
from onika.desk.environment.reconcile.loop_watchdog import LoopWatchdog
from onika.desk.environment.reconcile.multiplexer import Multiplexer
from onika.desk.environment.reconcile.runtime_rest import RuntimeRest
from onika.desk.environment.reconcile.watches import Watch, recorded_homes
from onika.desk.environment.state.model import Model
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.runtime_conversation import RuntimeConversation, in_short
from onika.link.lost import LinkLost
from onika.wire import event, page, request
from onika.words.reason import NOTHING, Reason, reason_of

_PATIENCE_S = 1.0
"""How long the thread has to end, and as long again once a runtime that was launched here has been killed."""

Post = Callable[[Callable[[], None]], None]
"""Has something done in the environment's own thread, after what was posted before."""


class RuntimeOpening(Protocol):
    """How a runtime is got hold of."""

    def __call__(
        self, url: str, token: str, simulator: Simulator | None = None
    ) -> AbstractContextManager[RuntimeConversation]:
        """At an address, or where that is empty one that is started here; raises LinkLost, ValueError, OSError."""
        ...


class RuntimeThread:
    """Carries orders to a runtime and what it tells to the environment; a slow runtime never keeps anybody waiting.

    Everything about the runtime happens in one thread, which also launches it: a child lives as long as the thread.

    station     whose runtime it is; empty: that of the first one
    """

    def __init__(self, opening: RuntimeOpening, post: Post, station: str = "") -> None:
        self._opening = opening
        self._station = station
        self._post = post
        self._orders: deque[Order] = deque()
        self._bell, self._door = socket.socketpair()
        self._bell.setblocking(False)
        self._door.setblocking(False)
        self._is_over = False
        self._is_let_go = False
        self._rest = RuntimeRest()
        self._thread: Thread | None = None
        self._entered: AbstractContextManager[RuntimeConversation] | None = None
        self._runtime: RuntimeConversation | None = None
        self._multiplexer: Multiplexer | None = None
        self._url = ""
        self._tokens: dict[str, str] = {}
        self._environment: Environment | None = None
        self._vouch = LoopWatchdog(post, self._ring, monotonic)
        self._watching = Watch()
        self._attended: tuple[Watch, Model] | None = None
        self._focus: tuple[Model, Model] | None = None
        self._quality = runtime_loss.NOT_MEASURED
        self._frames = FrameBuffer()

    # -- from any thread

    def begin(self, environment: Environment) -> None:
        """Work for this environment from now on."""
        self._environment = environment
        self._thread = Thread(target=self._run, name="station", daemon=True)
        self._thread.start()

    def send(self, order: Order) -> None:
        """Ask; the environment is told the response. What stops is sent first."""
        if isinstance(order.asked, request.Stop):
            self._orders.appendleft(order)
        else:
            self._orders.append(order)
        self._ring()

    def watch(self, variables: frozenset[str], worlds: frozenset[str], figures: bool, hz: float) -> None:
        """What somebody wants to see from now on, variables as `DOC/NAME`."""
        self._watching = Watch(variables, worlds, figures, hz)
        self._ring()

    def rest(self) -> None:
        """Let a simulator that was launched here rest until somebody has to do with it: nothing happens in it."""
        self._rest.is_wished = True
        self._ring()

    def wake(self) -> None:
        """Somebody may have to do with it."""
        if self._rest.is_wished:
            self._rest.is_wished = False
            self._ring()

    def frame(self) -> page.Frame | None:
        """What is new since the last call; late values were dropped."""
        return self._frames.take()

    @property
    def pid(self) -> int | None:
        """The process id of a runtime that was launched here; None: there is none."""
        runtime = self._runtime
        return runtime.pid if runtime is not None else None

    def let_go(self) -> None:
        """End the thread without waiting for it; its runtime is elsewhere."""
        self._is_let_go = self._is_over = True
        self._ring()

    def end(self) -> None:
        """End the thread, and with it a runtime that was launched here."""
        self._is_over = True
        self._ring()
        if self._thread is not None:
            self._thread.join(_PATIENCE_S)
            if self._thread.is_alive():
                self._end_launched()
                self._thread.join(_PATIENCE_S)
            if self._thread.is_alive():
                return  # it waits for a runtime elsewhere; it ends with this program
        self._close()

    def _close(self) -> None:
        self._bell.close()
        self._door.close()

    def _end_launched(self) -> None:
        """The thread waits for a runtime that does not answer, perhaps not even when it starts."""
        entered = self._entered
        if isinstance(entered, LaunchedRuntime):
            entered.end_at_once()

    # -- in the thread

    def _run(self) -> None:
        try:
            while not self._is_over:
                self._wait()
                if self._is_alone:
                    continue
                self._rest.end(self._entered)
                self._send_out()
                self._listen()
                self._rest.lie_down(self._entered, self._is_busy)
        finally:
            self._leave()
            if self._is_let_go:
                self._close()

    def _ring(self) -> None:
        try:
            self._bell.send(b"!")
        except (BlockingIOError, OSError):
            return  # it has rung already, or nobody is there any more

    @property
    def _is_alone(self) -> bool:
        """Whether this thread is there and the environment is not: to a runtime elsewhere both are silent then."""
        return bool(self._url) and self._vouch.is_missing

    @property
    def _is_busy(self) -> bool:
        """Whether something is to be asked, or was asked and is not answered."""
        return bool(self._orders) or self._multiplexer is None or self._multiplexer.is_owed

    def _wait(self) -> None:
        readers: list[int] = [self._door.fileno()]
        writers: list[int] = []
        wait_s = None
        is_watched = not self._is_alone and not self._rest.goes_on
        if self._runtime is not None and self._multiplexer is not None and is_watched:
            readers += self._runtime.readers()
            writers = self._runtime.writers()
            times = [self._runtime.due_s(), self._multiplexer.poll_figures(self._watching.figures)]
            times += [self._vouch.ask(), self._multiplexer.poll_round_trip()] if self._url else []
            wait_s = min((time for time in times if time is not None), default=None)
        if not self._orders or self._is_alone:
            select.select(readers, writers, [], wait_s)
        try:
            self._door.recv(4096)
        except BlockingIOError:
            return

    def _send_out(self) -> None:
        while self._orders:
            order = self._orders.popleft()
            if order.reach is not None:
                refused = self._reach(order.reach)
                if refused:
                    self._reply([(order, request.Refused(refused))])
                    continue
            if self._multiplexer is None:
                self._reply([(order, request.Refused(Reason.of("run.not_linked")))])
            else:
                self._multiplexer.ask(order)

    def _listen(self) -> None:
        multiplexer, environment = self._multiplexer, self._environment
        if multiplexer is None or environment is None:
            return
        try:
            self._attend(multiplexer, self._watching, environment.model)
            came = multiplexer.hear()
        except LinkLost as lost:
            self._lose(multiplexer, lost.reason)
            return
        except ValueError as wrong:  # another version's words, or garbage
            self._lose(multiplexer, Reason.of("run.not_understood", why=reason_of(wrong)))
            return
        self._tell_quality(multiplexer, environment)
        if came:
            self._post(lambda: self._tell(environment, came))
        model = self._focused(environment.model)
        self._frames.put(self._noted(environment, multiplexer.readings(), model), multiplexer.figures, model)
        if multiplexer.figures is not None:
            loads, cycles_us = multiplexer.figures.loads, multiplexer.figures.cycles_us
            self._become(environment, lambda model: runtime_loss.with_loads(model, loads, cycles_us))

    def _noted(self, environment: Environment, readings: dict[str, bytes], model: Model) -> dict[str, bytes]:
        """What is new and somebody looks at; where all is recorded, it is told besides."""
        if not readings or not recorded_homes(model):
            return readings
        self._post(lambda: environment.measured(self._station, readings))
        return self._watching.wanted(readings, model)

    def _attend(self, multiplexer: Multiplexer, watch: Watch, model: Model) -> None:
        """What is listened to follows from these two alone; neither changes in place."""
        before, self._attended = self._attended, (watch, model)
        if before is None or before[0] is not watch or before[1] is not model:
            multiplexer.attend(watch.attend(self._focused(model)))

    def _tell_quality(self, multiplexer: Multiplexer, environment: Environment) -> None:
        """Whether the runtime is heard, and how long the way to it is, where either has changed."""
        runtime = self._runtime
        is_cut = runtime is not None and not runtime.is_heard
        trip_s = multiplexer.round_trip_s
        quality = (is_cut, -1.0 if trip_s is None else trip_s * 1e3)
        if not runtime_loss.is_other_quality(self._quality, quality):
            return
        self._quality = quality
        self._become(environment, lambda model: runtime_loss.with_quality(model, *quality))

    def _focused(self, model: Model) -> Model:
        """The model with this station in focus; the same object as long as nothing changes."""
        if self._focus is None or self._focus[0] is not model:
            self._focus = (model, model.at(self._station))
        return self._focus[1]

    def _reach(self, reach: RequiredRuntime) -> Reason:
        """Have the runtime there; why it is not, else nothing."""
        if self._multiplexer is not None and not reach.is_anew and (not reach.url or reach.url == self._url):
            return NOTHING
        orphans = self._multiplexer.orphans(Reason.of("run.started_anew")) if self._multiplexer is not None else []
        self._leave()
        self._reply(orphans)
        token = reach.token or self._tokens.get(reach.url, "")
        try:
            self._entered = self._opening(reach.url, token, reach.simulator)
            self._runtime = self._entered.__enter__()
        except LinkLost as lost:
            self._entered = self._runtime = None
            return lost.reason
        except (ValueError, OSError) as wrong:
            self._entered = self._runtime = None
            return reason_of(wrong)
        self._url = reach.url
        self._tokens[reach.url] = token
        self._multiplexer, self._attended = Multiplexer(self._runtime, monotonic), None
        self._quality = runtime_loss.NOT_MEASURED
        self._frames.clear()
        return NOTHING

    def _lose(self, multiplexer: Multiplexer, reason: Reason) -> None:
        environment = self._environment
        orphans = multiplexer.orphans(in_short(reason))
        self._leave()
        if environment is not None:
            self._become(environment, lambda model: runtime_loss.lost(model, reason))
        self._reply(orphans)

    def _reply(self, answered: list[tuple[Order, request.Response]]) -> None:
        environment = self._environment
        if environment is not None:
            self._post(lambda: self._tell(environment, list(answered)))

    def _leave(self) -> None:
        """Let the runtime go; one that was launched here ends."""
        self._rest.end(self._entered)
        entered, self._entered = self._entered, None
        self._runtime = self._multiplexer = None
        self._url = ""
        if entered is not None:
            entered.__exit__(None, None, None)

    def _become(self, environment: Environment, change: Callable[[Model], Done]) -> None:
        self._post(lambda: environment.become(change, self._station))

    def _tell(self, environment: Environment, came: Sequence[event.Event | tuple[Order, request.Response]]) -> None:
        for message in came:
            if isinstance(message, tuple):
                environment.replied(*message)
            else:
                environment.receive(message, self._station)
