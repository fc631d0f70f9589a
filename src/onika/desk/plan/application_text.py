"""Converts an application between its file and text in the words of AL, in both directions (requirement D14)."""

from dataclasses import dataclass, field
from pathlib import Path

from onika.files import appl, text, whole
from onika.files.al import reader, writer
from onika.model.application import Application
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.store.opened_text import OpenedText, put, save
from onika.store.site import Site
from onika.words.fault import Fault, Place, Refusal, parted
from onika.words.name import TASK_NAME
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Converted:
    """What came of a conversion: the other form of the application, and what is wrong; with faults there is none."""

    application: Application | None
    content: str
    faults: tuple[Fault, ...]
    notes: tuple[Fault, ...] = ()


def is_text(path: Path) -> bool:
    """Whether a file is a text in the words of AL, by its ending."""
    return path.name.endswith(reader.ENDING)


def convert(path: Path, out: Path | None, site: Site, *, is_whole: bool = False) -> Converted:
    """The application in `path` in its other form: as text, or from text as the content of an `.appl`.

    Icons are looked up in the dictionaries of the site, those of the base directories of `out` and `path` first.
    `is_whole`: the text defines all its icons and needs no dictionary.
    """
    site = _at_home(_at_home(site, path), out) if out else _at_home(site, path)
    syntax, faults = site.syntax()
    content, unread = text.load(path, str(path))
    if content is None or syntax is None:
        return _converted(None, "", (*faults, *unread))
    dictionaries = _Dictionaries(site, syntax)
    if is_text(path):
        name = out.name.removesuffix(appl.ENDING) if out else path.stem
        application, faults_of_file = reader.read(content, name, str(path), syntax, dictionaries.find)
        made = appl.write(application) if application else ""
    else:
        application, faults_of_file = appl.read(content, path.name.removesuffix(appl.ENDING), str(path), syntax)
        made = (
            writer.write(application, syntax, (lambda _: None) if is_whole else dictionaries.find)
            if application
            else ""
        )
    return _converted(application, made, (*faults, *faults_of_file), dictionaries.faults)


def unfit(path: Path, out: Path) -> Fault | None:
    """Why the other form of `path` may not be called `out`, if so."""
    wanted = appl.ENDING if is_text(path) else reader.ENDING
    if not out.name.endswith(wanted):
        return Fault(
            Place(str(out)),
            Reason.of("desk.file_ending", wanted=wanted, name=out.name),
            Reason.of("desk.nothing_written"),
        )
    if wanted == appl.ENDING and not TASK_NAME.match(out.name.removesuffix(wanted)):
        return Fault(Place(str(out)), Reason.of("desk.name_form", name=out.name), Reason.of("desk.nothing_written"))
    return None


def keep(converted: Converted, out: Path, *, overwrites: bool) -> Refusal | None:
    """Save what was converted; refused where there is a file already, unless `overwrites`.

    An `.appl` that is overwritten keeps its comments.
    """
    saved: OpenedText[Application] | OpenedText[str] | Refusal
    if converted.application is not None and not is_text(out):
        saved = save(out, converted.application, appl.write, None, overwrites=overwrites)
    else:
        saved = put(out, converted.content, converted.content, whole.ANYTHING if overwrites else whole.ABSENT)
    return saved if isinstance(saved, Refusal) else None


@dataclass(slots=True)
class _Dictionaries:
    """The dictionaries of a site, each icon read once."""

    site: Site
    syntax: Syntax
    faults: tuple[Fault, ...] = ()
    _known: dict[str, Onikon | None] = field(default_factory=dict)

    def find(self, name: str) -> Onikon | None:
        if name not in self._known:
            self._known[name], faults = self.site.onikon(name, self.syntax)
            self.faults += faults
        return self._known[name]


def _at_home(site: Site, path: Path) -> Site:
    folder = path.absolute().parent
    if folder.name == "appl":
        return site.at(folder.parent)
    return site


def _converted(
    application: Application | None, content: str, faults: tuple[Fault, ...], dictionary_faults: tuple[Fault, ...] = ()
) -> Converted:
    """A conversion whose faulty dictionary icons are told, but forbid nothing by themselves."""
    mistakes, notes = parted(faults)
    if application is not None:
        return Converted(application, content, (), (*mistakes, *notes, *dictionary_faults))
    return Converted(None, "", (*mistakes, *dictionary_faults), notes)
