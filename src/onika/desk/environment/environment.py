"""The environment: the one writer of what is open; every act gets exactly one answer."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol, cast

from msgspec import Struct

from onika.desk.environment.file import undo
from onika.desk.environment.outcome.gathered_responses import GatheredResponses
from onika.desk.environment.outcome.outcome import (
    Ask,
    AskAll,
    AwaitedNews,
    Done,
    InterimModel,
    No,
    Order,
    Procedure,
    SubsystemChange,
    Work,
)
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.parameter_log import changed_parameters
from onika.desk.environment.reconcile import following
from onika.desk.environment.show.tree import Projector
from onika.desk.environment.show.tree_difference import difference
from onika.desk.environment.state.model import Model
from onika.desk.environment.station_focus import located, of_station, station_of
from onika.desk.environment.undo_notice import others
from onika.wire import act, event, live, page, request
from onika.wire.view import Tree
from onika.words.reason import Reason

Handler = Callable[[Model, Any, Services], Done | No | Procedure]
"""What an act does: of a model, the act and the outside. One that waits is a generator."""


class ModelListener(Protocol):
    """Whoever is shown what changes."""

    def patch(self, patch: page.Patch) -> None:
        """Something has changed."""
        ...

    def say(self, message: page.Say) -> None:
        """Something is worth a line."""
        ...


class RuntimeChannel(Protocol):
    """The way to the runtimes of all stations."""

    def send(self, order: Order) -> None:
        """Ask that of the order's station; `Environment.replied` is told its response later, in our own thread."""
        ...


@dataclass(frozen=True, slots=True)
class ActAnswer:
    """What an act gets: a value, or a no."""

    value: Any = None
    no: No | None = None


@dataclass(frozen=True, slots=True, eq=False)
class _Act:
    """An act that is carried out: how it goes on where it waits, who gets its answer, and which station it is about."""

    steps: Procedure | None
    answer: Callable[[ActAnswer], None]
    station: str = ""


class Environment:
    """Carries acts out one after the other, and tells its listeners what has changed.

    handlers    what each act does
    channel     where orders go
    """

    def __init__(
        self, model: Model, handlers: Mapping[type, Handler], surroundings: Services, channel: RuntimeChannel
    ) -> None:
        self._handlers = handlers
        self._surroundings = surroundings
        self._channel = channel
        self._projector = Projector()
        self._gathered = GatheredResponses()
        self._waiting: dict[Hashable, list[_Act]] = {}
        """Acts by what they wait for: a response, work that is done aside, a change of a running system."""
        self.model = model
        self.listeners: list[ModelListener] = []
        self.observers: list[Callable[[act.AnyAct, str], Callable[[ActAnswer], None]]] = []
        """Told of every act that begins, and by whom; what each returns is told how it ended: the diary."""
        self.listening: list[Callable[[str, str, Struct], None]] = []
        """Told of what a runtime tells, before it changes anything: station, which request that answers, message."""
        self.measuring: list[Callable[[str, Mapping[str, bytes]], None]] = []
        """Told what variables hold that are recorded, by station and `SUBSYSTEM/NAME`."""
        self.followers: list[Callable[[Model, Model], None]] = []
        """Told of every change, with what there was before."""
        self.revision = 0
        self.tree: Tree = self._projector.project(model)

    def do(self, command: act.AnyAct, by: str, answer: Callable[[ActAnswer], None]) -> None:
        """Carry an act out, and answer it once: now, or when the runtime has said what comes of it."""

        ends = [observer(command, by) for observer in self.observers]

        def tell(given: ActAnswer) -> None:
            for end in ends:
                end(given)
            answer(given)

        station = station_of(self.model, command)
        if station not in self.model.stations:
            tell(ActAnswer(no=No(Reason.of("desk.no_station", name=station))))
            return
        before = self.model.at(station)
        result = self._handlers[type(command)](before, command, self._surroundings)
        steps, first = (None, result) if isinstance(result, Done | No) else (result, _next(result, None))
        outcome = self._followed(before, first, by, command)
        if isinstance(outcome, Done) and outcome.awaits is not None:
            steps = _taken_up(outcome, outcome.awaits)
            outcome = _next(steps, None)
        self._go_on(_Act(steps, tell, before.station), outcome, by)

    def replied(self, order: Order, response: request.Response) -> None:
        """A runtime has replied to an order."""
        for listener in self.listening:
            listener(order.station or "", type(order.asked).__name__, response)
        if order.then is not None:
            self._adopt(order.then(self.model.at(order.station or ""), response), "")
        gathered = self._gathered.take(order, response)
        self._come(*(gathered or (order.identity, response)))

    def receive(self, message: event.Event, station: str = "") -> None:
        """The runtime of a station has told something."""
        for listener in self.listening:
            listener(station, "", message)
        if station in self.model.stations:
            self._adopt(of_station(following.after_event(self.model.at(station), message, self._surroundings)), "")

    def measured(self, station: str, readings: Mapping[str, bytes]) -> None:
        """What variables of a station hold, of which all are wanted for a recording."""
        for listener in self.measuring:
            listener(station, readings)

    def become(self, change: Callable[[Model], Done], station: str = "") -> None:
        """A change from outside: a file, a link to a station, a command that ended."""
        if station not in self.model.stations:
            return  # it was let go meanwhile
        before = self.model.at(station)
        done = change(before)
        followed = following.follow(before, done.model, self._surroundings)
        if isinstance(followed, No):
            self.say(page.Say("error", followed.reason))
            return
        orders, says = (*done.orders, *followed.orders), (*done.says, *followed.says)
        news = (*done.news, *followed.news)
        self._adopt(replace(done, model=followed.model, orders=orders, says=says, news=news), "")

    def say(self, message: page.Say) -> None:
        """Show everybody a line."""
        for listener in self.listeners:
            listener.say(message)

    def _go_on(self, carried: _Act, outcome: InterimModel | Done | No, by: str = "") -> None:
        """Answer an act that has come to its end; keep one that waits by what it waits for."""
        if isinstance(outcome, No):
            carried.answer(ActAnswer(no=located(outcome, carried.station)))
            return
        if isinstance(outcome, Done):
            self._adopt(outcome, by)
            carried.answer(ActAnswer(outcome.value))
            return
        orders, carried = outcome.orders, replace(carried, station=outcome.model.station)
        if isinstance(outcome, Ask):
            order = Order(outcome.request, reach=outcome.reach, station=carried.station)
            orders = (order, *orders)
            self._waiting[order.identity] = [carried]
        elif isinstance(outcome, AskAll):
            orders = (*self._gathered.begin(outcome), *orders)
            self._waiting[outcome] = [carried]
        elif isinstance(outcome, AwaitedNews):
            self._waiting.setdefault(outcome.what, []).append(carried)
        self._adopt(Done(outcome.model, orders=orders, says=outcome.says, news=outcome.news), by)
        if isinstance(outcome, Work):
            self._waiting[outcome] = [carried]
            outcome.worker.answer(outcome.work, outcome)
        elif type(outcome) is InterimModel:
            self._resume(carried, None)

    def _come(self, what: Hashable, news: Any) -> None:
        """What acts may wait for has come; a refusal that none waits for is worth a line."""
        acts = self._waiting.pop(what, ())
        for carried in acts:
            self._resume(carried, news)
        if not acts and isinstance(what, SubsystemChange) and isinstance(news, No):
            self.say(page.Say("error", news.reason, what.doc))

    def _resume(self, carried: _Act, news: Any) -> None:
        if carried.steps is not None:
            self._go_on(carried, _next(carried.steps, (self.model.at(carried.station), news)))

    def _followed(
        self, before: Model, outcome: InterimModel | Done | No, by: str, command: act.AnyAct
    ) -> InterimModel | Done | No:
        """Make a step of what was done to a document, and have the running system follow."""
        if isinstance(outcome, No):
            return outcome
        model = undo.stepped(before, outcome, by, command) if isinstance(outcome, Done) else outcome.model
        followed = following.follow(before, model, self._surroundings)
        if isinstance(followed, No):
            return followed
        says = (*others(before, command, by), *outcome.says, *followed.says)
        news = (*outcome.news, *followed.news)
        if isinstance(outcome, Done):
            orders = (*_but_of_ended(followed.orders, outcome.orders), *outcome.orders)
            awaits = followed.awaits
            return replace(outcome, model=followed.model, orders=orders, says=says, news=news, awaits=awaits)
        return replace(outcome, model=followed.model, orders=(*outcome.orders, *followed.orders), says=says, news=news)

    def _adopt(self, done: Done, by: str) -> None:
        logged = tuple(changed_parameters(self.model, done.model))
        before, self.model = self.model, done.model.at("")
        self._show(by)
        for follower in self.followers:
            follower(before, self.model)
        for message in (*done.says, *logged):
            self.say(message)
        for order in done.orders:
            self._channel.send(order.at(done.model.station))
        for what, news in done.news:
            self._come(what, news)

    def _show(self, by: str) -> None:
        tree = self._projector.project(self.model)
        changes: Sequence[page.Change] = difference(self.tree, tree)
        self.tree = tree
        if not changes:
            return
        self.revision += 1
        patch = page.Patch(self.revision, tuple(changes), by)
        for listener in tuple(self.listeners):
            listener.patch(patch)


def _next(steps: Procedure, news: tuple[Model, Any] | None) -> InterimModel | Done | No:
    """What an act does until it waits again, or ends."""
    try:
        return next(steps) if news is None else steps.send(news)
    except StopIteration as end:
        return cast(Done | No, end.value)


def _taken_up(done: Done, change: SubsystemChange) -> Procedure:
    """An act that changes a running system, answered when the change is accepted or refused."""
    model, refused = yield AwaitedNews(done.model, change, says=done.says, orders=done.orders, news=done.news)
    return Done(model, value=done.value) if refused is None else refused


def _but_of_ended(orders: Sequence[Order], done: Sequence[Order]) -> tuple[Order, ...]:
    """Without the release of subsystems that are ended: whoever ends one has to hold it."""
    ended = {order.asked.subsystem for order in done if isinstance(order.asked, live.Close)}
    return tuple(
        order for order in orders if not (isinstance(order.asked, live.Release) and order.asked.subsystem in ended)
    )
