"""How long acts take on a large canvas: a thousand tasks in the library, half of them placed.

Usage: python tools/bench/canvas.py [--tasks 1000] [--rounds 15]
"""

import argparse
import tempfile
import time
from pathlib import Path
from statistics import median

from onika.desk.environment.environment import ActAnswer, Environment
from onika.desk.environment.file.configurations import opened_beside
from onika.desk.environment.file.disk_watch import DiskWatch
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.refresh import refreshed
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.rules import loci, placement
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.wire import act

_PRIME = 7919
"""Scatters the inputs over the variables, the same way every time."""


class Large:
    """An environment with a large library and a large configuration, `c1`, in it."""

    def __init__(self, folder: Path, count: int) -> None:
        base = BaseDirectory(folder)
        (folder / "module").mkdir(parents=True)
        for task in tasks(count):
            base.task_file(task.name).write_text(rmod.write(RmodText(task)), encoding="utf-8")
        self.site = Site((base,), shipped() / "prefs")
        model = Model(OpenLibraries(open_libraries([base])))
        half = count // 2
        self.placed = tuple(f"t{number:05}" for number in range(half))
        self.free = f"t{count - 1:05}"
        canvas = Configuration("large", tuple(_spot(name, number) for number, name in enumerate(self.placed)))
        canvas = loci.settled(canvas, model.libraries.boxes(self.placed), Configuration(""))
        model = opened_beside(model, None, None, canvas).model
        surroundings = Services(self.site, time.monotonic)
        self.environment = Environment(model, HANDLERS, surroundings, self)

    def send(self, order: Order) -> None:
        """Nothing runs here."""
        raise AssertionError(f"expected nothing to ask of a runtime, found {order}")

    def do(self, asked: act.AnyAct) -> float:
        """Carry an act out; the seconds it took."""
        began = time.perf_counter()
        self.environment.do(asked, "bench", _accepted)
        return time.perf_counter() - began

    def seconds(self, there: act.AnyAct, back: act.AnyAct, rounds: int) -> tuple[list[float], list[float]]:
        """The times of an act and of what takes it back."""
        both = [(self.do(there), self.do(back)) for _ in range(rounds)]
        return [one for one, _ in both], [other for _, other in both]


def tasks(count: int) -> list[Task]:
    """Half of them are wired to each other, most others write what those write, the last tenth could be placed too."""
    half = count // 2
    return [_task(number, half, count - count // 10) for number in range(count)]


def _task(number: int, half: int, free: int) -> Task:
    like = number if number < half or number >= free else number - half
    reads = tuple(dict.fromkeys(f"V{(number * 4 + n) * _PRIME % (2 * half)}" for n in range(4)))
    return Task(
        f"t{number:05}",
        f"m{number if number < half or number >= free else number - number % 2 * half}",
        inconst=(f"C{number % 40}",),
        outconst=(f"C{number}",) if number < 40 else (),
        invar=reads,
        outvar=(f"V{2 * like}", f"V{2 * like + 1}"),
        frequency=100.0,
    )


def _spot(name: str, number: int) -> Placed:
    return Placed(name, number % 25 * 220, number // 25 * 260)


def _accepted(answer: ActAnswer) -> None:
    if answer.no is not None:
        raise AssertionError(f"expected an act that is done, found {answer.no}")


def main(arguments: list[str] | None = None) -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tasks", type=int, default=1_000, help="in the library")
    parser.add_argument("--rounds", type=int, default=15, help="how often each is done")
    given = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as folder:
        large = Large(Path(folder), given.tasks)
        libraries = large.environment.model.libraries
        standing = [libraries.tasks[name] for name in large.placed]
        one = large.placed[0]
        pairs = (
            ("place", "undo", act.Place("c1", large.free, 37, 41), act.Undo("c1")),
            ("move", "undo", act.Move("c1", {one: (3, 3)}), act.Undo("c1")),
            ("remove", "undo", act.Remove("c1", (one,)), act.Undo("c1")),
            ("alias", "undo", act.Alias(large.free, f"V{2 * given.tasks - 2}", "ELSE", "c1"), act.Undo("c1")),
            ("rate", "back", act.LibraryRate(large.free, 5.0), act.LibraryRate(large.free, 100.0)),
        )
        print(f"{'act':<16}{'ms':>8}")
        for name, back, there, again in pairs:
            both = large.seconds(there, again, given.rounds)
            for said, times in zip((name, f"{back} ({name})"), both, strict=True):
                print(f"{said:<16}{median(times) * 1e3:>8.2f}")
        disk, model = DiskWatch(large.site), large.environment.model
        every = {large.site.directories[0].task_file(name) for name in libraries.tasks}
        for said, what in (
            ("greyed anew", lambda: placement.greyed(libraries.tasks.values(), standing)),
            ("look at disk", lambda: disk.changed(model)),
            ("all touched", lambda: refreshed(model, every)),
        ):
            times = []
            for _ in range(given.rounds):
                began = time.perf_counter()
                what()
                times.append(time.perf_counter() - began)
            print(f"{said:<16}{median(times) * 1e3:>8.2f}")


if __name__ == "__main__":
    main()
