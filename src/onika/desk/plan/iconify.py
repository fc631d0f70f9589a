"""Makes icons: a configuration becomes a job, an application an icon for others (requirement D09, §5.6.2, §5.6.4)."""

from dataclasses import dataclass, replace
from pathlib import Path

from onika.files import appl, conf, onk, text
from onika.model.configuration import Configuration
from onika.model.initials import drawn
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.model.rules.iconify import ActionType, application_type, job_type
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import OpenedText
from onika.store.own_copy import saving_place
from onika.store.site import Site
from onika.words.fault import Fault, Place, Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

Reasons = tuple[Fault | Refusal, ...]

_FOLDERS = {conf.ENDING: "conf", appl.ENDING: "appl"}


@dataclass(frozen=True, slots=True)
class IconifiedFile:
    """An icon, the file it stands in now, and what is worth knowing."""

    path: Path
    onikon: Onikon
    notes: tuple[Fault, ...] = ()


@dataclass(frozen=True, slots=True)
class _Source:
    """The file an icon is made of."""

    path: Path
    home: BaseDirectory
    site: Site
    syntax: Syntax

    @property
    def name(self) -> str:
        return self.path.stem

    @property
    def is_application(self) -> bool:
        return self.path.suffix == appl.ENDING


def iconify(
    path: Path, site: Site, *, description: str | None = None, picture: Path | None = None, replaces: bool = False
) -> IconifiedFile | Reasons:
    """Write `dict/NAME.onk` for the configuration or application in the file `path`; or say why not.

    An icon that is there keeps its description and picture, unless others are given; `picture` is the file of an icon
    that lends its own. One of another thing of that name is kept (reading 34), unless the user `replaces` it.
    """
    source = _source(path, site)
    if not isinstance(source, _Source):
        return source
    present, faults = _former(source)
    former = None if isinstance(present, Refusal) else present
    objections = (present,) if isinstance(present, Refusal) else faults
    if former is None and objections and not replaces:
        return objections
    notes = faults if former else ()
    kind = _type(source)
    if not isinstance(kind, ActionType):
        return kind
    lent = _lent(picture, source.syntax)
    if not isinstance(lent, Picture | None):
        return lent
    onikon = _onikon(source.name, kind, former.value if former else None, description, lent)
    home = saving_place(source.home.path, site)
    if isinstance(home, Refusal):
        return (home,)
    saved = home.save_onikon(onikon, former, overwrites=replaces)
    if isinstance(saved, Refusal):
        return (saved,)
    return IconifiedFile(saved.path, onikon, notes)


def _onikon(
    name: str, kind: ActionType, former: Onikon | None, description: str | None, lent: Picture | None
) -> Onikon:
    """The icon; what is not given it takes from the one that was there before."""
    usual = former or Onikon(name, kind.type, "", (), drawn(name))
    wording = usual.description if description is None else description
    words = usual.words if usual.description == wording else ()
    return Onikon(name, kind.type, " ".join(wording.split()), (), lent or usual.picture, kind.more_targets, words)


def _source(path: Path, site: Site) -> _Source | Reasons:
    folder = path.absolute().parent
    place = Place(str(path))
    if path.suffix not in _FOLDERS or not path.is_file():
        return (_not_made(place, Reason.of("desk.icon_source")),)
    if folder.name != _FOLDERS[path.suffix]:
        reason = Reason.of("desk.icon_folder", folder=_FOLDERS[path.suffix], given=folder.name)
        return (_not_made(place, reason),)
    if not TASK_NAME.match(path.stem):
        return (_not_made(place, Reason.of("desk.icon_name", name=path.stem)),)
    syntax, faults = site.syntax()
    if syntax is None:
        return faults
    return _Source(path, BaseDirectory(folder.parent), site.at(folder.parent), syntax)


def _former(source: _Source) -> tuple[OpenedText[Onikon] | Refusal | None, tuple[Fault, ...]]:
    """The icon that is there; a refusal where it is that of something else."""
    file = source.home.onikon_file(source.name)
    if not file.exists():
        return None, ()
    former, faults = source.home.open_onikon(source.name, source.syntax)
    if former is None:
        return None, faults
    kind = source.syntax.acting(former.value.type)
    is_ours = kind is not None and (kind.is_application if source.is_application else kind.is_job)
    if is_ours:
        return former, tuple(fault for fault in faults if not fault.is_note)
    reason = Reason.of("desk.icon_of_another", path=str(file), kind=former.value.type)
    rename = Reason.of("desk.rename_file", name=source.path.name)
    return Refusal(reason, (rename, Reason.of("desk.replace_icon"))), ()


def _type(source: _Source) -> ActionType | Reasons:
    content, faults = text.load(source.path, str(source.path))
    if content is None:
        return faults
    if source.is_application:
        application, faults = appl.read(content, source.name, str(source.path), source.syntax)
        if application is None:
            return faults
        return application_type(application, source.syntax)
    configuration, faults = conf.read(content, source.name, str(source.path))
    if configuration is None:
        return faults
    return _job(source, configuration)


def _job(source: _Source, configuration: Configuration) -> ActionType | Reasons:
    filed: dict[str, Task] = {}
    wrong: list[Fault] = []
    for placed in configuration.placed:
        record, faults = source.site.task(placed.file)
        if record is not None:
            filed[placed.file] = record.task
        wrong += () if record else faults
    return tuple(wrong) or job_type(configuration, configuration.tasks(filed), source.syntax)


def _lent(path: Path | None, syntax: Syntax) -> Picture | Reasons | None:
    """The picture of another icon's file; None where none is named."""
    if path is None:
        return None
    content, faults = text.load(path, str(path))
    if content is None:
        return tuple(replace(fault, instead=Reason.of("desk.no_icon_made")) for fault in faults)
    onikon, faults = onk.read(content, path.stem, str(path), syntax)
    return onikon.picture if onikon else faults


def _not_made(place: Place, reason: Reason) -> Fault:
    return Fault(place, reason, Reason.of("desk.no_icon_made"))
