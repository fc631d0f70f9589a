"""24 behaviours that succeed at once under one sequence with memory: one tick of py_trees goes through them all."""

from importlib.metadata import version
from time import perf_counter_ns

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from beside.contestant import Figures, serve

ACTIONS = 24


class Step(Behaviour):
    """Succeeds."""

    def update(self) -> Status:
        """At once."""
        return Status.SUCCESS


def main() -> None:
    """The contestant."""
    root = Sequence("all", memory=True, children=[Step(f"step{number:02}") for number in range(ACTIONS)])

    def measure(ticks: int) -> Figures:
        began = perf_counter_ns()
        for _ in range(ticks):
            root.tick_once()
        took = perf_counter_ns() - began
        if root.status is not Status.SUCCESS:
            raise RuntimeError(f"expected a success, found {root.status}")
        return {"figure": took / 1e3 / ticks}

    serve(version("py_trees"), measure)


if __name__ == "__main__":
    main()
