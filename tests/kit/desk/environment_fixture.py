"""An environment to try acts on: its answers, its lines, and the copy that a page would hold of its tree."""

import os
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from queue import Queue
from typing import Any

import msgspec

from onika.desk.environment.environment import ActAnswer, Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.button_commands import Commands
from onika.desk.environment.outcome.outcome import Done, No, Order
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.wire import act, page
from onika.wire.view import ButtonView, Tree


class EnvironmentFixture:
    """Acts go in by `do`; whatever a page would be told is kept, and its copy of the tree stays equal."""

    def __init__(
        self, folder: Path, tasks: Iterable[Task] = (), model: Model | None = None, site: Site | None = None
    ) -> None:
        self.base = BaseDirectory(folder)
        for task in tasks:
            self.base.save_task(RmodText(task))
        self.home = folder / "home"
        self.site = site or Site((self.base,), shipped() / "prefs", self.home)
        opened = model or Model(OpenLibraries(open_libraries([self.base])))
        self.orders: list[Order] = []
        self.says: list[page.Say] = []
        self.changes: Queue[Callable[[Model], Done]] = Queue()
        commands = Commands(self.changes.put, os.environ)
        self.surroundings = Services(
            self.site,
            time.monotonic,
            folder / "state",
            commands,
            reading=BackgroundWorker(self.changes.put),
            comparing=BackgroundWorker(self.changes.put),
            keeping=BackgroundWorker(self.changes.put),
            meshing=BackgroundWorker(self.changes.put),
        )
        self.begin(opened)

    def begin(self, model: Model) -> None:
        """Begin anew with this model, among the surroundings as they are."""
        self.environment = Environment(model, HANDLERS, self.surroundings, self)
        self.copy: dict[str, Any] = _plain(self.environment)
        self.environment.listeners.append(self)

    def do(self, request: act.AnyAct, by: str = "me") -> Any:
        """Carry an act out that is not refused; its value."""
        answer = self.answer(request, by)
        if answer.no is not None:
            raise AssertionError(f"{request} was refused: {answer.no}")
        return answer.value

    def no(self, request: act.AnyAct) -> No:
        """Why an act is refused, and that it changed nothing."""
        before = self.environment.model
        answer = self.answer(request)
        if answer.no is None or self.environment.model is not before:
            raise AssertionError(f"{request} was not refused, or changed something")
        return answer.no

    def answer(self, request: act.AnyAct, by: str = "me") -> ActAnswer:
        """The one answer that an act gets at once."""
        given: list[ActAnswer] = []
        self.environment.do(request, by, given.append)
        if len(given) != 1:
            raise AssertionError(f"{request} was answered {len(given)} times")
        return given[0]

    def later(self, request: act.AnyAct, by: str = "me") -> ActAnswer:
        """The answer that an act gets when what it needs has been done aside; raises queue.Empty without one."""
        given: list[ActAnswer] = []
        self.environment.do(request, by, given.append)
        while not given:
            self.become()
        return given[0]

    def become(self) -> None:
        """Wait for the next change from outside; raises queue.Empty where nothing comes for a long time."""
        self.environment.become(self.changes.get(timeout=30))

    def new(self, *tasks: str) -> str:
        """A new configuration with these tasks beside each other; its id."""
        doc: str = self.do(act.New())
        for column, name in enumerate(tasks):
            self.do(act.Place(doc, name, 200 * column, 100))
        return doc

    def button(self, name: str, until: Callable[[ButtonView], bool]) -> ButtonView:
        """A button as soon as it is as it is waited for; raises queue.Empty where nothing comes for a long time."""
        while not until(self.environment.tree.buttons[name]):
            self.become()
        return self.environment.tree.buttons[name]

    def patch(self, patch: page.Patch) -> None:
        """As a page does: the copy follows, and is what the tree is."""
        for path, value in patch.changes:
            _put(self.copy, path, value)
        if msgspec.convert(self.copy, Tree) != self.environment.tree:
            raise AssertionError("the page's copy differs from the tree")

    def say(self, sentence: page.Say) -> None:
        """Keep a line."""
        self.says.append(sentence)

    def send(self, order: Order) -> None:
        """Keep an order."""
        self.orders.append(order)


def _plain(environment: Environment) -> dict[str, Any]:
    builtins: dict[str, Any] = msgspec.to_builtins(environment.tree)
    return builtins


def _put(tree: dict[str, Any], path: tuple[str, ...], value: Any) -> None:
    *way, last = path
    for step in way:
        tree = tree.setdefault(step, {})
    if value is None:
        tree.pop(last, None)
    else:
        tree[last] = value
