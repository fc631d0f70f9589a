"""Judging open applications soon after each change: whether they are ready, and what is wrong, all at once (E01).

It reads files, and may take a while where an application is long; therefore it is done beside everything else, and what
comes of it is of the application as it was when it was looked at.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from operator import is_
from pathlib import Path
from typing import Any

from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.run_state.membership import icons
from onika.desk.environment.runs import unsaved
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.runs.unsaved import Changed
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Judgement, OpenApplication
from onika.desk.plan import redirection
from onika.desk.plan.flow_guests import guests_by_flow
from onika.desk.plan.flow_worlds import worlds_by_flow
from onika.desk.plan.preparation import PreparedRun
from onika.model.application import Application
from onika.model.redirect import Redirect
from onika.model.syntax import Syntax
from onika.store.cached_site import RememberingSite, Stamp
from onika.store.program import ApplicationProgram
from onika.store.site import Site
from onika.store.world_source import world_path
from onika.wire import act
from onika.wire.view import FaultView, Remedy
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class ReadinessCase:
    """An application to be judged, as it was when somebody looked."""

    opened: OpenApplication
    syntax: Syntax
    dirty: tuple[Changed, ...]
    has_new_files: bool = False
    """Whether files that it uses have changed."""


@dataclass(frozen=True, slots=True)
class _Known:
    """What an application was judged with."""

    application: Application
    syntax: Syntax
    dirty: tuple[Changed, ...]
    stamps: tuple[Stamp, ...]
    program: ApplicationProgram | None
    redirects: tuple[Redirect, ...] = ()
    of_worlds: tuple[Path, ...] = ()
    """The files of its worlds, and those in which something was wrong."""


class ReadinessJudge:
    """Knows what was judged with what; one thing is asked of it at a time, in whatever thread."""

    def __init__(self, site: Site) -> None:
        self._site = RememberingSite.of(site)
        self._known: dict[str, _Known] = {}
        self._seen: tuple[Any, ...] = ()

    def cases(self, model: Model) -> tuple[ReadinessCase, ...]:
        """The applications that are not judged as they are now."""
        seen = (model.documents, model.applications, model.syntax)
        if model.syntax is None or all(map(is_, seen, self._seen or (None,) * 3)):
            return ()
        self._seen = seen
        dirty = unsaved.dirty(model)
        self._known = {doc: case for doc, case in self._known.items() if doc in model.applications}
        every = (ReadinessCase(application, model.syntax, dirty) for application in model.applications.values())
        return tuple(case for case in every if self._is_new(case))

    def stale(self, model: Model) -> tuple[ReadinessCase, ...]:
        """Those whose files have changed since."""
        if model.syntax is None:
            return ()
        dirty = unsaved.dirty(model)
        judged = []
        for opened in model.applications.values():
            former = self._known.get(opened.id)
            if former is not None and former.stamps != self._stamps(opened, former.program, former.of_worlds):
                judged.append(ReadinessCase(opened, model.syntax, dirty, has_new_files=True))
        return tuple(judged)

    def judge(self, case: ReadinessCase) -> Judgement:
        """What is wrong with an application, and what is worth knowing of it."""
        opened = case.opened
        prepared = ready(opened, self._site, case.syntax)
        of_worlds = _files_of_worlds(self._home(opened), prepared)
        stamps = self._stamps(opened, prepared.program, of_worlds)
        self._known[opened.id] = _Known(
            opened.application, case.syntax, case.dirty, stamps, prepared.program, opened.redirects, of_worlds
        )
        troubles = FaultViews.of(opened, case.syntax, prepared, self._site)
        fault_views = (*troubles.views(prepared), *_unsaved(case, troubles, prepared.program), *_unchosen(opened))
        worlds = worlds_by_flow(prepared.plan) if prepared.plan is not None else {}
        guests = guests_by_flow(prepared.plan) if prepared.plan is not None else {}
        homes = _homes(opened, prepared)
        return Judgement(opened.application, fault_views, case.has_new_files, homes, worlds, guests)

    def _is_new(self, case: ReadinessCase) -> bool:
        former = self._known.get(case.opened.id)
        if former is None or former.application is not case.opened.application or former.syntax is not case.syntax:
            return True
        if former.redirects != case.opened.redirects:
            return True
        return former.dirty != case.dirty

    def _home(self, opened: OpenApplication) -> Site:
        return self._site if opened.base is None else self._site.at(opened.base)

    def _stamps(
        self, opened: OpenApplication, program: ApplicationProgram | None, of_worlds: tuple[Path, ...]
    ) -> tuple[Stamp, ...]:
        """Of all files that count, also of those that are not there."""
        home = self._home(opened)
        if program is None:
            return self._site.stamps(_files_of(home, [opened.application]))
        applications = [opened.application, *program.applications.values()]
        files = (*_files_of(home, applications), *_files_of_tasks(home, program), *program.code.values())
        return self._site.stamps((*files, *of_worlds))


def _files_of(home: Site, applications: Iterable[Application]) -> list[Path | None]:
    """The files behind the icons of applications; what an icon stands for may be of either kind."""
    names = dict.fromkeys(icon.onikon.name for application in applications for icon in icons(application))
    return [*(home.configuration_file(name) for name in names), *(home.application_file(name) for name in names)]


def _files_of_worlds(home: Site, prepared: PreparedRun) -> tuple[Path, ...]:
    """The files of the worlds that a plan drives; of one that is at fault its text, and what else is at fault."""
    if prepared.plan is None:
        return ()
    driven = dict.fromkeys(world for worlds in worlds_by_flow(prepared.plan).values() for world in worlds)
    texts = filter(None, (world_path(world.partition("@")[0], home) for world in driven))
    read = (Path(file.path) for source in prepared.plan.worlds for file in source.files)
    wrong = (Path(fault.place.file) for fault in prepared.faults)
    return tuple(dict.fromkeys((*texts, *read, *(path for path in wrong if path.is_absolute()))))


def _files_of_tasks(home: Site, program: ApplicationProgram) -> list[Path | None]:
    """The files of the tasks of all configurations of a program."""
    configurations = program.configurations.values()
    tasks = dict.fromkeys(placed.file for configuration in configurations for placed in configuration.placed)
    bases = [(name, home.home_of_task(name)) for name in tasks]
    return [base.task_file(name) if base else None for name, base in bases]


def judged(model: Model, doc: str, judgement: Judgement) -> Done:
    """The model with what was found; the same where that is nothing new."""
    opened = model.applications.get(doc)
    if opened is None:
        return Done(model)
    if judgement.has_new_files and (opened.looked is not None or opened.foretelling is not None):
        opened = replace(opened, looked=None, foretelling=None)
    former = opened.judgement
    if former is not None and former.faults == judgement.faults:
        judgement = replace(judgement, faults=former.faults, has_new_files=False)
        stays = (former.homes, former.worlds, former.guests) == (judgement.homes, judgement.worlds, judgement.guests)
        is_same = former.of is judgement.of and stays
        if is_same and opened is model.applications[doc]:
            return Done(model)
    return Done(model.with_application(replace(opened, judgement=judgement)))


def _homes(opened: OpenApplication, prepared: PreparedRun) -> dict[str, tuple[str, ...]]:
    plan, program = prepared.plan, prepared.program
    if plan is None or program is None:
        return {}
    return {redirect.old: redirection.homes_of(redirect, plan, program) for redirect in opened.redirects}


def _unsaved(case: ReadinessCase, troubles: FaultViews, program: ApplicationProgram | None) -> Iterator[FaultView]:
    for doc, name in unsaved.used(case.dirty, program):
        save = Remedy(Reason.of("run.save", name=name), act.Save(doc))
        yield FaultView(Reason.of("run.unsaved_use", name=name), "warning", troubles.user_of(name), (save,))


def _unchosen(opened: OpenApplication) -> Iterator[FaultView]:
    """Of several flows one is chosen by what stood before the application; where it is run by itself, nothing does."""
    application = opened.application
    if not application.is_parallel and len(application.flows) > 1:
        last = next((step.number for step in reversed(application.flows[0].steps)), 0)
        branch = act.InsertBranch(opened.id, "0", last, len(application.flows))
        insert = Remedy(Reason.of("run.insert_branch"), branch)
        yield FaultView(Reason.of("run.chosen_flow_0"), "warning", 0, (insert,))
