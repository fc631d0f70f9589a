"""What the browsers together want to see of the running system, and what is asked of a runtime for it."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isnan

from onika.desk.environment.reconcile import watched_runs
from onika.desk.environment.state.model import Model
from onika.wire import holding, live

FASTEST_HZ = 60.0
_SLOWEST_HZ = 0.1
_INTO = "@"
_WORLD = "world:"


@dataclass(frozen=True, slots=True)
class Watch:
    """A wish: variables as `DOC/NAME` or `@SUBSYSTEM/NAME`, worlds, figures of all tasks, how often at most.

    What is of another station than the first one names it: `@SUBSYSTEM@STATION/NAME`, `STATION/WORLD`.
    """

    variables: frozenset[str] = frozenset()
    worlds: frozenset[str] = frozenset()
    figures: bool = False
    hz: float = 0.0

    def wanted(self, readings: Mapping[str, bytes], model: Model) -> dict[str, bytes]:
        """Of what has come, by `SUBSYSTEM/NAME`, what somebody looks at."""
        watched = frozenset(self._watched(model))
        return {
            key: body
            for key, body in readings.items()
            if key in watched or f"{key.rpartition('/')[0]}/*" in watched or key.startswith(_WORLD)
        }

    def _watched(self, model: Model) -> list[str]:
        """The variables that are looked at, as `SUBSYSTEM/NAME`."""
        homes = {**homes_of(model), **homes_within(model)}
        keys = [key.partition("/") for key in sorted(self.variables)]
        of_documents = [f"{homes[doc]}/{name}" for doc, _, name in keys if doc in homes and name]
        return [*of_documents, *(home for doc, _, name in keys if (home := _home_in_run(model, doc, name)))]

    def attend(self, model: Model) -> live.Attend:
        """What is asked of the runtime with which the documents of this model are connected."""
        recorded = [f"{home}/*" for home in recorded_homes(model)]
        readings = tuple(dict.fromkeys((*self._watched(model), *recorded)))
        worlds = tuple(sorted(name for world in self.worlds if (name := world_at(model.station, world))))
        hz = _SLOWEST_HZ if isnan(self.hz) else min(max(self.hz, _SLOWEST_HZ), FASTEST_HZ)
        hz = max(hz, live.RECORDED_HZ) if recorded else hz
        # others' runs tell the same words; the own one is heard of by its subsystems too where it was handed over
        own = {home for run in model.runs_here for home in run.homes}
        attended = (*sorted({*homes_of(model).values(), *own}), holding.COMPANY) if is_going(model) else ("*",)
        return live.Attend(attended, readings, worlds, hz)


def recorded_homes(model: Model) -> tuple[str, ...]:
    """The subsystems here of runs at several stations that are recorded: of these all values are told."""
    recorded = [run for run in model.going_here if run.parts and run.view.recording]
    return tuple(home for run in recorded for home in run.homes_at(model.station))


def keys_of(model: Model, key: str) -> tuple[str, ...]:
    """Under which names a reading `SUBSYSTEM/NAME` is shown: `DOC/NAME`, of a run `DOC/SUBSYSTEM/NAME` too.

    Of any running application it is shown as `@SUBSYSTEM/NAME` besides.
    """
    subsystem, _, name = key.rpartition("/")
    homes = {**homes_of(model), **homes_within(model)}
    of_documents = [f"{doc}/{name}" for doc, home in homes.items() if home == subsystem]
    run = next((run for run in model.runs_here if subsystem in run.view.flows), None)
    if run is None:
        return tuple(of_documents)
    is_first = _home_in_run(model, run.doc, name) == key
    return (*of_documents, f"{run.doc}/{key}", *([f"{run.doc}/{name}"] if is_first else []))


def is_going(model: Model) -> bool:
    """Whether an application of this environment runs here, or is about to."""
    return bool(model.going_here)


def _home_in_run(model: Model, doc: str, name: str) -> str:
    """Where a variable `[SUBSYSTEM/]NAME` of the run of an application is; else empty."""
    run = model.run_of(doc)
    if run is None or not name:
        return ""
    try:
        subsystem, variable = run.flow_index.home(name)
    except ValueError:
        return ""
    return f"{subsystem}/{variable}" if run.station_of(subsystem) == model.station else ""


def homes_within(model: Model) -> dict[str, str]:
    """The subsystems of running applications: as `@SUBSYSTEM`, and by the documents that look into them."""
    behind = f"@{model.station}" if model.station else ""
    into = {f"{_INTO}{subsystem}{behind}": subsystem for subsystem in model.runtime.inside}
    return into | watched_runs.homes(model)


def world_of(station: str, name: str) -> str:
    """A world, or a camera in it, as it is named beside those of other stations; of the first one by its name."""
    return f"{station}/{name}" if station else name


def world_at(station: str, name: str) -> str:
    """The name that a world so named has at this station; empty: it is another one's."""
    of, _, there = name.rpartition("/")
    return there if of == station else ""


def homes_of(model: Model) -> dict[str, str]:
    """The subsystems of the documents that are connected, by their ids."""
    return {
        doc: document.live.subsystem
        for doc, document in model.documents_here.items()
        if document.live is not None and document.live.state == "live"
    }
