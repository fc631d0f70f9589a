"""Opening a configuration of 50 and of 500 tasks and arranging it: from the act to the patch that a page is sent."""

import argparse
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.store.site import Site
from onika.wire import act

_CHAIN = 8
"""Tasks from one end of a chain to the other; each also reads what the chain before wrote."""


class _NoRuntime:
    def send(self, order: Order) -> None:
        """Nothing lives."""


def fill(base: BaseDirectory, count: int) -> Path:
    """A library of so many tasks, and a configuration of them without places or loci; gives its file."""
    for number in range(count):
        reads = tuple(f"V{other}" for other in (number - 1, number - _CHAIN) if other >= 0)
        base.save_task(RmodText(Task(f"t{number}", f"m{number}", invar=reads, outvar=(f"V{number}",), frequency=100.0)))
    base.save_configuration(Configuration("many", tuple(Placed(f"t{number}") for number in range(count))))
    return base.configuration_file("many")


def measure(count: int, rounds: int) -> tuple[float, float]:
    """Seconds to open it, and to arrange it; the middle of some rounds."""
    with tempfile.TemporaryDirectory() as folder:
        base = BaseDirectory(Path(folder))
        path = str(fill(base, count))
        site = Site((base,), Path(folder) / "prefs", Path(folder))
        opened, arranged = [], []
        for _ in range(rounds):
            model = Model(OpenLibraries(open_libraries([base])))
            environment = Environment(model, HANDLERS, Services(site, perf_counter), _NoRuntime())
            opened.append(_seconds(environment, act.Open(path)))
            doc = next(doc for doc, document in environment.model.documents.items() if document.name == "many")
            arranged.append(_seconds(environment, act.Arrange(doc)))
        return median(opened), median(arranged)


def _seconds(environment: Environment, command: act.AnyAct) -> float:
    began = perf_counter()
    environment.do(command, "bench", lambda answer: None)
    return perf_counter() - began


def main() -> None:
    """Measure, and print a line for each size."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    for count in (50, 500):
        opening, arranging = measure(count, rounds)
        print(f"{count:5} tasks: opened in {opening * 1e3:6.1f} ms, arranged in {arranging * 1e3:6.1f} ms")


if __name__ == "__main__":
    main()
