"""The environment: the one writer of what is open; every act gets exactly one answer (house decision 5)."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

from onika.desk.environment import following
from onika.desk.environment.file import application_undo, undo
from onika.desk.environment.outcome.outcome import Done, No, Order
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.show.tree import Projector
from onika.desk.environment.show.tree_difference import difference
from onika.desk.environment.state.history import File, Step
from onika.desk.environment.state.model import Model
from onika.desk.environment.undo_notice import others
from onika.wire import act, event, live, page, request
from onika.wire.view import Tree

Handler = Callable[[Model, Any, Surroundings], Done | No]
"""What an act does: of a model, the act and the outside."""


class Listener(Protocol):
    """Whoever is shown what changes."""

    def patch(self, patch: page.Patch) -> None:
        """Something has changed."""
        ...

    def say(self, said: page.Say) -> None:
        """Something is worth a line."""
        ...


class Station(Protocol):
    """The way to a runtime."""

    def send(self, order: Order) -> None:
        """Ask; `Environment.replied` is called with the response later, in the environment's own thread."""
        ...


@dataclass(frozen=True, slots=True)
class Answer:
    """What an act gets: a value, or a no."""

    value: Any = None
    no: No | None = None


@dataclass(frozen=True, slots=True)
class _Waiting:
    """An act that is answered later, and what its answer says if the runtime says nothing more."""

    tell: Callable[[Answer], None]
    value: Any

    def value_of(self, outcome: Done | None) -> Any:
        """What the answer says."""
        return self.value if outcome is None or outcome.value is None else outcome.value


class Environment:
    """Carries acts out one after the other, and tells its listeners what has changed.

    handlers    what each act does
    station     where orders go
    """

    def __init__(
        self, model: Model, handlers: Mapping[type, Handler], surroundings: Surroundings, station: Station
    ) -> None:
        self._handlers = handlers
        self._surroundings = surroundings
        self._station = station
        self._projector = Projector()
        self._waiting: dict[int, _Waiting] = {}
        self.model = model
        self.listeners: list[Listener] = []
        self.observers: list[Callable[[act.AnyAct, str, Answer], None]] = []
        """Told of every act, by whom and how it ended: the diary."""
        self.revision = 0
        self.tree: Tree = self._projector.project(model)

    def do(self, asked: act.AnyAct, by: str, answer: Callable[[Answer], None]) -> None:
        """Carry an act out, and answer it once: now, or when the runtime has said what comes of it."""

        def tell(given: Answer) -> None:
            for observer in self.observers:
                observer(asked, by, given)
            answer(given)

        before = self.model
        outcome = self._handlers[type(asked)](before, asked, self._surroundings)
        if isinstance(outcome, No):
            tell(Answer(no=outcome))
            return
        outcome = self._recorded(before, outcome, by, asked)
        if isinstance(outcome, No):
            tell(Answer(no=outcome))
            return
        if outcome.is_answered_later:
            self._waiting[id(outcome.orders[0])] = _Waiting(tell, outcome.value)
        self._adopt(outcome, by)
        if not outcome.is_answered_later:
            tell(Answer(outcome.value))

    def replied(self, order: Order, response: request.Response) -> None:
        """A runtime has replied to an order."""
        outcome = order.then(self.model, response) if order.then else None
        waiting = self._waiting.pop(id(order), None)
        if isinstance(outcome, Done) and outcome.is_answered_later and waiting is not None:
            self._waiting[id(outcome.orders[0])], waiting = waiting, None
        done = outcome.instead if isinstance(outcome, No) else outcome
        if done is not None:
            self._adopt(done, "")
        if waiting is not None:
            waiting.tell(Answer(no=outcome) if isinstance(outcome, No) else Answer(waiting.value_of(outcome)))
        elif isinstance(outcome, No):
            self.say(page.Say("error", outcome.reason, order.doc))

    def heard(self, told: event.Event) -> None:
        """A runtime has told something."""
        self._adopt(following.heard(self.model, told, self._surroundings), "")

    def become(self, change: Callable[[Model], Done]) -> None:
        """A change from outside: a file, a link, a command that ended."""
        done = change(self.model)
        followed = following.follow(self.model, done.model, self._surroundings)
        if isinstance(followed, No):
            self.say(page.Say("error", followed.reason))
            return
        orders, says = (*done.orders, *followed.orders), (*done.says, *followed.says)
        replies = (*done.replies, *followed.replies)
        self._adopt(replace(done, model=followed.model, orders=orders, says=says, replies=replies), "")

    def say(self, said: page.Say) -> None:
        """Show everybody a line."""
        for listener in self.listeners:
            listener.say(said)

    def _recorded(self, before: Model, done: Done, by: str, asked: act.AnyAct) -> Done | No:
        """Make a step of what was done to a document, and have the running system follow."""
        model = self._stepped(before, done, by, asked)
        followed = following.follow(before, model, self._surroundings)
        if isinstance(followed, No):
            return followed
        is_answered_later = done.is_answered_later or any(not one.is_aside for one in followed.orders)
        behind = _but_of_ended(followed.orders, done.orders)
        orders = (*done.orders, *behind) if done.is_answered_later else (*behind, *done.orders)
        return replace(
            done,
            model=followed.model,
            orders=orders,
            says=(*others(before, asked, by), *done.says, *followed.says),
            replies=followed.replies,
            is_answered_later=is_answered_later,
        )

    def _stepped(self, before: Model, done: Done, by: str, asked: act.AnyAct) -> Model:
        """With one more step in the history of the document that was changed."""
        if done.doc in before.applications and done.doc in done.model.applications:
            return done.model if isinstance(asked, act.Undo | act.Redo) else application_undo.stepped(before, done, by)
        if not done.doc or done.doc not in done.model.documents or done.doc not in before.documents:
            return done.model
        old, new = before.documents[done.doc], done.model.documents[done.doc]
        edited = undo.edits_between(before.shelf, done.model.shelf)
        model = done.model
        if done.label and (old.content != new.content or edited) and not isinstance(asked, act.Undo | act.Redo):
            backwards = undo.edits_between(done.model.shelf, before.shelf)
            step = Step(done.label, by, old.content, new.content, backwards, edited, before.shelf, done.model.shelf)
            if isinstance(asked, act.OpenInPlace):
                files = File(old.opened, old.base), File(new.opened, new.base)
                step = replace(step, file_before=files[0], file_after=files[1])
            model = model.with_document(replace(new, history=new.history.done(step)))
        return model

    def _adopt(self, done: Done, by: str) -> None:
        self.model = done.model
        self._show(by)
        for said in done.says:
            self.say(said)
        for order in done.orders:
            if not order.is_kept:
                self._station.send(order)
        for order, response in done.replies:
            self.replied(order, response)

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


def _but_of_ended(orders: Sequence[Order], done: Sequence[Order]) -> tuple[Order, ...]:
    """Without the release of subsystems that are ended: whoever ends one has to hold it."""
    ended = {one.asked.subsystem for one in done if isinstance(one.asked, live.Close)}
    return tuple(one for one in orders if not (isinstance(one.asked, live.Release) and one.asked.subsystem in ended))
