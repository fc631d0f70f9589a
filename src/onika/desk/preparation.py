"""Preparing a run: from a name or file to a plan, with every fault that needs no runtime to be seen (E01)."""

from dataclasses import dataclass
from pathlib import Path

from onika.desk.compile import Compiler
from onika.model.application import Application
from onika.model.rules import meetings, readiness, warning
from onika.model.rules.union import tasks_of
from onika.store.program import Program, load
from onika.store.site import Site
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.words.fault import Fault, Place, parted


@dataclass(frozen=True, slots=True)
class PreparedRun:
    """What could be read and compiled; nothing may run while there are faults."""

    name: str
    application: Application | None
    plan: Plan | None
    targets: tuple[TargetValues, ...]
    faults: tuple[Fault, ...]
    notes: tuple[Fault, ...] = ()
    """What is worth knowing and forbids nothing: what files were read with, inputs that nobody writes, names that
    stand twice."""


def prepare_run(name_or_path: str, site: Site) -> PreparedRun:
    """Read an application and all it needs, judge it by every rule, compile what is there."""
    path = site.application_file(name_or_path)
    if path is None:
        known = sorted({name for base in site.directories for name in base.applications})
        expected = f"an application file or the name of one ({', '.join(known) or 'none on the search path'})"
        fault = Fault(Place(name_or_path), expected, "neither", "nothing is run")
        return _nothing(name_or_path, (fault, *site.absent()))
    syntax, faults = site.syntax()
    if syntax is None:
        return _nothing(name_or_path, faults)
    program, read = load(path, site, syntax)
    if program is None:
        return _nothing(name_or_path, (*faults, *read))
    place = Place(str(path))
    judged = readiness.faults(
        program.application,
        syntax,
        program.configurations,
        program.tasks,
        place,
        applications=program.applications,
        files=program.files,
        unread=program.unread,
    )
    folder = path.absolute().parent
    home = site.at(folder.parent) if folder.name == "appl" else site
    places = _places(program, home)
    compiler = Compiler(program, syntax, place, places, lambda name: str(home.application_file(name) or name))
    plan = compiler.plan()
    met = meetings.findings(plan)
    told = _notes(program, home, places)
    found, notes = parted((*faults, *program.faults, *judged, *compiler.faults, *met, *told, *site.absent()))
    return PreparedRun(program.application.name, program.application, plan, tuple(compiler.targets), found, notes)


def _notes(program: Program, site: Site, places: dict[str, str]) -> tuple[Fault, ...]:
    notes: list[Fault] = []
    for name, task in program.tasks.items():
        notes += warning.self_fed(task, Place(places[name]))
    for configuration in program.configurations.values():
        tasks = tasks_of([configuration], program.tasks)
        if len(tasks) == len(configuration.placed):
            notes += warning.hanging(tasks, Place(configuration.name))
    names = {program.application.name, *program.configurations, *program.tasks}
    notes += (one for one in site.duplicates() if Path(one.place.file).name in names)
    return tuple(notes)


def _nothing(name: str, faults: tuple[Fault, ...]) -> PreparedRun:
    found, notes = parted(faults)
    return PreparedRun(name, None, None, (), found, notes)


def _places(program: Program, home: Site) -> dict[str, str]:
    found = {name: home.home_of_task(name) for name in program.tasks}
    return {name: str(base.task_file(name)) for name, base in found.items() if base is not None}
