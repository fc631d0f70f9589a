"""An environment and a small honest runtime, without a thread between them: orders are carried out at once.

env = FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("Q",), frequency=10.0),))
doc = env.connected("a")
env.do(act.Toggle(doc, "a"))
assert env.state(doc, "a") == "ON"
"""

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.task import Task
from onika.store.site import Site
from onika.wire import act, event, live, request


class FakeRuntimeEnv(EnvironmentFixture):
    """`runtime` answers, and `others` at other stations, by their names.

    `rebuffs` are orders that they answer otherwise, by their kind; `is_held_back` keeps orders.
    """

    def __init__(
        self,
        folder: Path,
        tasks: Iterable[Task] = (),
        runtime: LiveRuntime | None = None,
        model: Model | None = None,
        site: Site | None = None,
    ) -> None:
        sheets = tuple(tasks)
        super().__init__(folder, sheets, model, site)
        for task in sheets:
            (folder / "module" / f"{task.module}.py").write_text(f'"""The code of {task.module}."""\n')
        self.runtime = runtime or LiveRuntime()
        self.others: dict[str, LiveRuntime] = {}
        self.rebuffs: Mapping[type, request.Response] = {}
        self.is_held_back = False
        self.carried_out: list[request.Request] = []
        self._waiting: deque[Order] = deque()

    def connected(self, *tasks: str) -> str:
        """A new configuration with these tasks, connected, all of them OFF; its id."""
        doc = self.new(*tasks)
        self.do(act.Connect(doc))
        return doc

    def answer(self, action: act.AnyAct, by: str = "me") -> ActAnswer:
        """The one answer that an act gets, when the runtime has done what it asks for."""
        given: list[ActAnswer] = []
        self.environment.do(action, by, given.append)
        self.pump()
        if len(given) != 1:
            raise AssertionError(f"{action} was answered {len(given)} times")
        return given[0]

    def send(self, order: Order) -> None:
        """Have an order carried out with the next `pump`."""
        super().send(order)
        self._waiting.append(order)

    def alias(self, task: str, coded: str, svar: str) -> None:
        """Another state variable behind a coded name, wherever the task is placed."""

        def change(model: Model) -> Done:
            sheet = model.libraries.tasks[task]
            changed = replace(sheet, aliases=(*sheet.aliases, (coded, svar)))
            return Done(replace(model, libraries=model.libraries.edited({task: changed})))

        self.environment.become(change)
        self.pump()

    def pump(self) -> None:
        """Carry out what was asked, and hear what is told, until nothing is left."""
        while self._waiting and not self.is_held_back:
            order = self._waiting.popleft()
            self.carried_out.append(order.asked)
            response = self.rebuffs.get(type(order.asked)) or self.runtime_at(order.station or "").ask(order.asked)
            self.environment.replied(order, response)
            self.hear()

    def tell(self, message: event.Event) -> None:
        """Let the runtime tell something, and hear it."""
        self.runtime.tell(message)
        self.hear()
        self.pump()

    def hear(self) -> None:
        """Hear what the runtimes have told."""
        for message in self.runtime.events(0.0):
            self.environment.receive(message)
        for station, runtime in self.others.items():
            for message in runtime.events(0.0):
                self.environment.receive(message, station)

    def runtime_at(self, station: str) -> LiveRuntime:
        """The runtime of a station; there is one wherever one is looked for."""
        return self.others.setdefault(station, LiveRuntime()) if station else self.runtime

    def document(self, doc: str) -> Document:
        """A document as it is now."""
        return self.environment.model.documents[doc]

    def state(self, doc: str, task: str) -> str:
        """The state that is shown of a task; raises KeyError where it is not on the canvas."""
        return self.environment.tree.documents[doc].tasks[task].state

    def edits(self) -> list[live.Change]:
        """The changes that the runtime was asked for."""
        return [message for message in self.carried_out if isinstance(message, live.Change)]
