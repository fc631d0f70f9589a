"""A run of an application kept as a test: it is carried out in simulators aside, and how far it is is shown (X07)."""

import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import msgspec

from onika.desk.environment.outcome.on_file import on_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.unread_faults import not_run
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.runs import unsaved
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.run.runtime_conversation import in_short
from onika.desk.run.settings import RunSettings
from onika.desk.trial.home import FOLDER
from onika.desk.trial.keeping import keep_in
from onika.files.kept import ENDING
from onika.store.shipped import is_shipped
from onika.store.site import Site
from onika.store.user_path import user_path
from onika.wire import act, page
from onika.wire.view import KeepingView, Remedy
from onika.words.condition import Condition
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

_NICE = 10


@on_application
def keep_test(model: Model, opened: OpenApplication, command: act.KeepTest, outside: Services) -> Done | No:
    """Begin to keep it; the value is the file."""
    if outside.keeping is None:
        return No(Reason.of("run.keep_nowhere"))
    if model.keeping is not None and model.keeping.state == "running":
        return No(Reason.of("run.keep_other", name=Path(model.keeping.path).name))
    expectations = _expectations(command.expects)
    if isinstance(expectations, No):
        return expectations
    path = _path(opened, command.path, outside)
    if isinstance(path, No):
        return path
    unrunnable = _unrunnable(opened)
    if unrunnable is not None:
        return unrunnable
    if path.exists() and not command.confirmed:
        again = msgspec.structs.replace(command, confirmed=True)
        return No(Reason.of("run.keep_there", path=str(path)), (Remedy(Reason.of("run.keep_replace"), again),))
    saved = _saved(model, opened, command, outside)
    if isinstance(saved, No):
        return saved
    opened = saved.applications[opened.id]
    home = outside.site if opened.base is None else outside.site.at(opened.base)
    settings = _settings(opened, expectations)
    outside.keeping.do(partial(_keep, outside.keeping, opened, path, settings, home))
    shown = KeepingView(opened.id, str(path))
    return Done(replace(saved, keeping=shown), value=str(path))


def _settings(opened: OpenApplication, expectations: tuple[Condition, ...]) -> RunSettings:
    """How the run that is kept is done."""
    return RunSettings(
        name=str(opened.opened.path) if opened.opened is not None else opened.name,
        is_virtual=True,
        expectations=expectations,
        redirects=opened.redirects,
    )


def _expectations(texts: Sequence[str]) -> tuple[Condition, ...] | No:
    conditions = []
    for text in filter(None, map(str.strip, texts)):
        try:
            conditions.append(Condition.parse(text))
        except ValueError as wrong:
            return No(reason_of(wrong), fields={"expects": reason_of(wrong)})
    return tuple(conditions)


def _path(opened: OpenApplication, wanted: str, outside: Services) -> Path | No:
    """The file; a name alone is one in the folder of tests beside the application, or of the user's own."""
    text = wanted.strip() or opened.name
    whole = user_path(text, outside.site.own)
    if isinstance(whole, Reason):
        return _unnamed(whole)
    given = whole if text.startswith(("/", "~")) else Path(text)
    if not given.name:
        return _unnamed(Reason.of("run.keep_name"))
    path = given if given.suffix == ENDING else given.with_name(f"{given.name}{ENDING}")
    if not path.is_absolute():
        own = outside.site.own
        base = own if opened.base is None or is_shipped(opened.base) else opened.base
        if base is None:
            return _unnamed(Reason.of("run.keep_no_base"))
        if path.name != str(path) or not TASK_NAME.match(path.stem):
            return _unnamed(Reason.of("run.keep_name"))
        path = base / FOLDER / path.name
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as wrong:
        return _unnamed(Reason.of("run.keep_folder", folder=str(path.parent), why=system_reason(wrong)))
    return path


def _unnamed(text: Reason) -> No:
    return No(text, fields={"path": text})


def _unrunnable(opened: OpenApplication) -> No | None:
    """Why a run of it needs not even be tried."""
    unread = not_run(opened)
    if unread is not None:
        return unread
    faults = [fault.text for fault in opened.judgement.faults if fault.level == "fault"] if opened.judgement else []
    if not opened.is_judged or not faults:
        return None
    several = Reason.of("run.and_more_faults", first=faults[0], count=len(faults) - 1)
    return No(Reason.of("run.cannot_run_as_it_is", name=opened.name, why=several if len(faults) > 1 else faults[0]))


def _saved(model: Model, opened: OpenApplication, command: act.KeepTest, outside: Services) -> Model | No:
    """With everything saved that the test would use: it does what files say."""
    if model.syntax is None:
        return No(Reason.of("run.no_icon_types"))
    dirty = unsaved.dirty(model)
    program = ready(opened, outside.site, model.syntax).program
    own = () if opened.opened is not None and not opened.is_dirty else ((opened.id, opened.name),)
    changed = tuple(dict.fromkeys((*unsaved.used(dirty, program), *unsaved.tasks(model, program), *own)))
    if not changed:
        return model
    if not command.saves_unsaved:
        remedy = Remedy(Reason.of("run.save_and_keep"), msgspec.structs.replace(command, saves_unsaved=True))
        return No(Reason.of("run.keep_unsaved", names=tuple(name for _, name in changed)), (remedy,))
    saved = unsaved.saved(model, changed, outside)
    return saved if isinstance(saved, No) else saved.model


def _keep(aside: BackgroundWorker, opened: OpenApplication, path: Path, settings: RunSettings, site: Site) -> None:
    """Do it, in a thread of its own; what comes of it is shown."""

    def progress(number: int, of: int) -> None:
        aside.tell(lambda model: Done(_shown(model, KeepingView(opened.id, str(path), run=number, of=of))))

    _stand_back()
    is_kept, lines = keep_in(path, settings, site, progress=progress)
    text = Reason.of("trial.reasons", reasons=tuple(map(in_short, lines)))
    shown = KeepingView(opened.id, str(path), "kept" if is_kept else "failed", text)
    if is_kept:
        say = page.Say("success", Reason.of("run.is_kept", name=path.name, text=text), opened.id)
    else:
        say = page.Say("error", Reason.of("run.is_not_kept", name=path.name, text=text), opened.id)
    aside.tell(lambda model: Done(_shown(model, shown), says=(say,)))


def _stand_back() -> None:
    """Simulators take what is left of the processor: a robot may be moving meanwhile."""
    if sys.platform == "linux":  # elsewhere it would be said of the whole program
        os.setpriority(os.PRIO_PROCESS, 0, _NICE)  # of this thread, and of what it starts


def _shown(model: Model, view: KeepingView) -> Model:
    return replace(model, keeping=view)
