"""Prepares a run: turns a name or file into a plan, with every fault seen without a runtime (requirement E01)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from onika.desk.plan import claimed_devices, loop_counters, redirection
from onika.desk.plan.compile import Compiler
from onika.model.application import Application, Icon, every_flow, without_breakpoints
from onika.model.redirect import Redirect
from onika.model.rules import meetings, readiness, warning
from onika.model.rules.union import tasks_of
from onika.model.syntax import Syntax
from onika.store.opened_text import Faults
from onika.store.program import ApplicationProgram, gather, home_of, joined, load
from onika.store.site import Site
from onika.store.world_source import gather_world
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.words.fault import Fault, Place, parted
from onika.words.reason import Reason


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
    program: ApplicationProgram | None = None
    """All that was read."""
    places: Mapping[str, str] = field(default_factory=dict)
    """The `.rmod` files of its tasks."""


def prepare_run(name_or_path: str, site: Site, redirects: Sequence[Redirect] = ()) -> PreparedRun:
    """Read an application and all it needs, judge it by every rule, compile what is there.

    redirects   the tasks that stand for others; the application's file is as it was
    """
    path = site.application_file(name_or_path)
    if path is None:
        names = sorted({name for base in site.directories for name in base.applications})
        present = tuple(names) or Reason.of("desk.none_on_path")
        fault = Fault(
            Place(name_or_path), Reason.of("desk.application_unknown", names=present), Reason.of("words.nothing_run")
        )
        return _nothing(name_or_path, (fault, *site.absent()))
    syntax, faults = site.syntax()
    if syntax is None:
        return _nothing(name_or_path, faults)
    program, read = load(path, site, syntax)
    if program is None:
        return _nothing(name_or_path, (*faults, *read))
    return _judged(program, syntax, Place(str(path)), home_of(path, site), faults, redirects)


def prepare(
    application: Application,
    place: Place,
    home: Site,
    syntax: Syntax,
    *,
    passes_breakpoints: bool = False,
    redirects: Sequence[Redirect] = (),
) -> PreparedRun:
    """Judge and compile an application that is there already, with all that it needs read from `home`.

    place   what stands for its file in faults and in the plan
    """
    program = gather(application, home, syntax)
    if passes_breakpoints:
        nested = {name: without_breakpoints(application) for name, application in program.applications.items()}
        program = replace(program, application=without_breakpoints(application), applications=nested)
    return _judged(program, syntax, place, home, (), redirects)


def _judged(
    program: ApplicationProgram, syntax: Syntax, place: Place, home: Site, faults: Faults, redirects: Sequence[Redirect]
) -> PreparedRun:
    program = joined(program, sorted({redirect.new for redirect in redirects if not redirect.is_of_world}), home)
    sound = redirection.sound(redirects, program)
    judged = readiness.faults(
        program.application,
        syntax,
        program.configurations,
        program.tasks,
        place,
        applications=program.applications,
        files=program.files,
        unread=program.unread,
        redirects=sound,
    )
    places = _places(program, home)

    def file_of(name: str) -> str:
        return str(home.application_file(name) or name)

    compiler = Compiler(program, syntax, place, places, file_of, sound, partial(gather_world, site=home))
    plan = compiler.plan()
    found_later = (*compiler.faults, *redirection.faults(redirects, plan, program))
    met = (*meetings.findings(plan), *claimed_devices.faults(plan), *loop_counters.faults(program, syntax, place.file))
    remarks = (*_notes(program, home, places), *_unreadable_icons(program, home, syntax))
    mistakes, notes = parted((*faults, *program.faults, *judged, *found_later, *met, *remarks, *home.absent()))
    name = program.application.name
    return PreparedRun(name, program.application, plan, tuple(compiler.targets), mistakes, notes, program, places)


def _notes(program: ApplicationProgram, site: Site, places: dict[str, str]) -> tuple[Fault, ...]:
    notes: list[Fault] = []
    for name, task in program.tasks.items():
        notes += warning.self_fed(task, Place(places[name]))
    for configuration in program.configurations.values():
        tasks = tasks_of([configuration], program.tasks)
        if len(tasks) == len(configuration.placed):
            notes += warning.hanging(tasks, Place(configuration.name))
    names = {program.application.name, *program.configurations, *program.tasks}
    notes += (duplicate for duplicate in site.duplicates() if Path(duplicate.place.file).name in names)
    return tuple(notes)


def _unreadable_icons(program: ApplicationProgram, site: Site, syntax: Syntax) -> Iterator[Fault]:
    """Icons whose files cannot be read: a run goes by what the application itself says of them, and tells so."""
    applications = (program.application, *program.applications.values())
    flows = (flow for application in applications for _, flow in every_flow(application))
    names = {step.onikon.name for flow in flows for step in flow.steps if isinstance(step, Icon)}
    for name in sorted(names):
        onikon, faults = site.onikon(name, syntax)
        if onikon is None and faults:
            yield replace(faults[0], instead=Reason.of("desk.own_icon_counts"), is_note=True)


def _nothing(name: str, faults: tuple[Fault, ...]) -> PreparedRun:
    mistakes, notes = parted(faults)
    return PreparedRun(name, None, None, (), mistakes, notes)


def _places(program: ApplicationProgram, home: Site) -> dict[str, str]:
    files = {name: program.task_files.get(name, name) for name in program.tasks}
    homes = {name: home.home_of_task(file) for name, file in files.items()}
    return {name: str(base.task_file(files[name])) for name, base in homes.items() if base is not None}
