"""A whole application of 24 actions that finish in their first cycle, by Onika's runtime program in virtual time.

Between two actions stands all that a real switch does: the trigger's signal, the engine's decision, the check of
writers, the old task off, the new task on with its argument line parsed, events told. Measured from the first
action's beginning to the last one's end; spawning and killing tasks are left out.
"""

from collections.abc import Callable
from time import perf_counter_ns

import onika
from beside.contestant import Figures, serve
from kit.plans.plan_builder import PlanBuilder, action
from onika.host.guards.call_watchdog import CallWatchdog
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.program import RuntimeProgram
from onika.host.units.virtual import VirtualDriver
from onika.wire import event, request

ACTIONS = 24

MODULE = """
from onika.module import InVar, Module, OutVar, finish

class Step(Module):
    trigger = True

    IN = InVar("double[6]", "-", "what somebody wrote")
    OUT = OutVar("double[6]", "-", "what somebody reads")

    def cycle(self):
        return finish()
"""


class RequestServer:
    """Hears what the runtime tells; keeps when the first action began, when the last was done, and the result."""

    def __init__(self) -> None:
        self.began_ns = self.done_ns = 0
        self.result: event.Result | None = None

    def tell(self, one: event.Event, subsystem: str = "", session: str = "") -> None:
        """Take it in."""
        if isinstance(one, event.Began):
            self.began_ns = self.began_ns or perf_counter_ns()
        elif isinstance(one, event.Done):
            self.done_ns = perf_counter_ns()
        elif isinstance(one, event.Result):
            self.result = one

    def requests(self) -> list[tuple[int, request.Request]]:
        """Nobody asks."""
        return []

    def reply(self, ticket: int, answer: request.Response) -> None:
        """Nobody asked."""

    def hearing(self, session: str) -> None:
        """Nobody is there who could be silent."""

    def deaf_ns(self) -> int:
        """It always hears."""
        return 0

    def overhear(self, ear: Callable[[event.Event, str], None] | None) -> None:
        """Nothing is recorded."""

    def sessions(self) -> tuple[()]:
        """Nobody is there."""
        return ()


class Application:
    """The application, prepared; every run is the same."""

    def __init__(self, actions: int = ACTIONS, watch: Callable[[str], None] = lambda _task: None) -> None:
        shop = PlanBuilder()
        names = [f"step{number:02}" for number in range(actions)]
        for number, name in enumerate(names):
            shop.task(name, MODULE, frequency=1000.0, aliases={"IN": f"V{number}", "OUT": f"V{number + 1}"})
        self._actions = actions
        self._prepared = prepare(shop.plan([action(name) for name in names]), (), ModuleFacts())
        if self._prepared.faults:
            raise ValueError(str(self._prepared.faults))
        self._watch = watch

    def run(self) -> float:
        """Microseconds from the first action's beginning to the last one's end."""
        server = RequestServer()
        driver = VirtualDriver(("rt0",), server.tell, watch=self._watch)
        program = RuntimeProgram(server, driver, ModuleFacts(), ("rt0",))  # type: ignore[arg-type]
        program.applications.take("", self._prepared)
        program.applications.begin("", request.Begin(settle_s=0.0))
        while server.result is None:
            program.advance(1_000_000_000)
        if not server.result.completed or server.result.done != self._actions:
            raise RuntimeError(f"expected {self._actions} actions done, found {server.result}")
        return (server.done_ns - server.began_ns) / 1e3


def main() -> None:
    """The contestant."""
    application = Application(watch=CallWatchdog().watch)

    def measure(runs: int) -> Figures:
        return {"figure": sum(application.run() for _ in range(runs)) / runs}

    serve(onika.__version__, measure)


if __name__ == "__main__":
    main()
