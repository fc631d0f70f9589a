"""So many idle tasks on one executive in virtual time: what one cycle costs."""

import onika
from beside.contestant import Figures, serve
from beside.sequence.onika_sweep import Sweep
from onika.host.guards.call_watchdog import CallWatchdog

CYCLES = 40_000


def main() -> None:
    """The contestant; a size is a number of tasks."""
    known: dict[int, Sweep] = {}
    watch = CallWatchdog().watch

    def measure(tasks: int) -> Figures:
        if tasks not in known:
            known[tasks] = Sweep(tasks, watch)
        return {"figure": known[tasks].run(max(1, CYCLES // tasks)) / tasks}

    serve(onika.__version__, measure)


if __name__ == "__main__":
    main()
