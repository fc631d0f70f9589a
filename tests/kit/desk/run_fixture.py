"""A run without a robot: an environment with an application, and a runtime whose words are those of the test.

play = RunFixture(tmp_path)
doc = play.open([job("aC"), job("bC")])
play.run(doc)
play.began(0)
play.done(0)
play.end()
assert play.view.is_completed

The tasks are `a`, `b` and `c`, each in a configuration of its own (`aC`, `bC`, `cC`); `a` claims the device `arm`.
"""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from kit.labs.laboratory import Laboratory
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.reconcile import runtime_loss
from onika.desk.environment.state.model import Model
from onika.model.lifecycle import State
from onika.wire import act, event, request
from onika.wire.view import RunView
from onika.words.reason import Reason, as_reason


class RunFixture(FakeRuntimeEnv):
    """A runtime that begins and then says nothing by itself; `files` is its base directory."""

    def __init__(self, folder: Path, rtpus: tuple[str, ...] = ("rt0",)) -> None:
        self.files = Laboratory(folder)
        for name in ("a", "b", "c"):
            self.files.module(name, f'"""The code of {name}."""\n')
            self.files.plain_task(name, writes=name.upper(), local="DEVICE arm\n" if name == "a" else "")
            self.files.configuration(f"{name}C", f"{name} 100")
        super().__init__(folder, runtime=LiveRuntime(rtpus))
        self.rebuffs = {request.Begin: request.Done()}
        syntax, _ = self.site.syntax()

        def ready(model: Model) -> Done:
            return Done(replace(model, syntax=syntax))

        self.environment.become(ready)

    def open(self, *flows: Sequence[str], name: str = "play", parallel: bool = False) -> str:
        """An application of these flows, opened; its id."""
        doc: str = self.do(act.Open(str(self.files.application(name, *flows, parallel=parallel))))
        return doc

    def run(self, doc: str) -> RunView:
        """Run it; what is shown when it has begun."""
        self.do(act.Run(doc))
        return self.view

    @property
    def view(self) -> RunView:
        """What is shown of the run; raises AssertionError where there is none."""
        view = self.environment.tree.run
        if view is None:
            raise AssertionError("nothing runs")
        return view

    def alive(self) -> None:
        """Let the tasks of all its flows live, OFF, and the environment look at them."""
        run = self.environment.model.run
        if run is None:
            raise AssertionError("nothing runs")
        for flow in run.plan.flows:
            self.runtime.perform(run.plan.application, flow.subsystem, flow.tasks)
        self.do(act.Company())

    def turned(self, task: str, state: State, *, subsystem: str = "flow0") -> None:
        """Let a task come into a state."""
        self.runtime.turn(subsystem, task, state)
        self.hear()
        self.pump()

    def began(self, index: int, *, flow: int = 0, at_s: float = 0.0) -> None:
        """Let an action begin."""
        run = self.environment.model.run
        action = run.action(flow, index) if run is not None else None
        if run is None or action is None:
            raise AssertionError(f"there is no action {index} in flow {flow}")
        self.tell(event.Began(flow, index, len(run.plan.flows[flow].actions), action.name, at_s))

    def done(self, index: int, *, flow: int = 0, at_s: float = 0.0) -> None:
        """Let an action be done."""
        self.tell(event.Done(flow, index, at_s))

    def moved(self, state: str, *, flow: str = "flow0", action: int = 0, at_s: float = 0.0, tag: str = "") -> None:
        """Let a flow come into a state; one that waits does so for flow0 or flow1."""
        other = ("flow1" if flow == "flow0" else "flow0",) if tag else ()
        self.tell(event.Moved(flow, state, action, at_s, tag, other))

    def end(self, cause: Reason | str = "", runtime_s: float = 9.0) -> None:
        """Let the run come to its end; with a cause before its time."""
        self.tell(event.Result(not cause, as_reason(cause), self.view.done, self.view.of, runtime_s, 0.0, {}, (), ""))

    def lose(self, reason: Reason | str) -> None:
        """Let the runtime be gone."""
        self.environment.become(lambda model: runtime_loss.lost(model, as_reason(reason)))

    def carried(self, kind: type) -> list[request.Request]:
        """What the runtime was asked of a kind, in order."""
        return [message for message in self.carried_out if isinstance(message, kind)]
