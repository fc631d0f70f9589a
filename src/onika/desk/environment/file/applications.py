"""Applications and their files: new, open, save, close, read again (requirements D04, X10)."""

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from onika.desk.environment.icons.branches import MOST_FLOWS
from onika.desk.environment.outcome.on_application import is_running, on_application, on_resting_application, running
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting, plain, unreadable
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.outcome.unread_faults import told
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.files import text
from onika.model.application import AppFlow, Application
from onika.model.flow_path import numbered
from onika.model.syntax import Syntax
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults, OpenedText
from onika.store.site import is_shipped
from onika.wire import act, page
from onika.wire.view import Remedy, ShowSaveAs
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME

READ_AGAIN = "reading the file again"


def new(model: Model, asked: act.NewApplication, outside: Surroundings) -> Done | No:
    """Open a blank application; the value is its id."""
    if model.syntax is None:
        return _no_syntax()
    if not 1 <= asked.flows <= MOST_FLOWS:
        form = f"from 1 to {MOST_FLOWS}"
        return No(f"an application has {form} flows, not {asked.flows}", fields={"flows": f"expected {form}"})
    blank = Application(model.blank_name(), asked.is_parallel, (AppFlow(()),) * asked.flows)
    number = model.opened + 1
    opened = OpenApplication(f"a{number}", blank)
    return Done(replace(model.with_application(opened), opened=number), value=opened.id)


def open_file(model: Model, asked: act.Open, outside: Surroundings) -> Done | No:
    """Open an application, as far as it can be read; one that is open already is shown."""
    if model.syntax is None:
        return _no_syntax()
    found = read(asked.path, model.syntax, outside)
    if isinstance(found, No):
        return found
    base, opened, _, _ = found
    for one in model.applications.values():
        if one.opened and one.opened.path == opened.path:
            return Done(model, value=one.id)
    number = model.opened + 1
    here = taken_over(OpenApplication(f"a{number}", opened.value, base=base.path), found)
    return Done(replace(model.with_application(here), opened=number), value=here.id)


@on_application
def save(model: Model, opened: OpenApplication, asked: act.Save, outside: Surroundings) -> Done | No:
    """Save an application; a file that could be read only in part is never overwritten without asking."""
    name = asked.name or opened.name
    if not TASK_NAME.match(name):
        form = "a name of letters, digits and _ . - that begins with a letter"
        return No(f"{name!r} is no name for a file", fields={"name": f"expected {form}"})
    own = outside.site.own
    base = Path(asked.base).expanduser().absolute() if asked.base else opened.base or (own if asked.name else None)
    if base is None:
        return No("it has no file yet: give it a name and a base directory", (Remedy("Save as…", show=ShowSaveAs()),))
    if is_shipped(base) and not asked.overwrites:
        return _shipped(asked, name, own)
    path = BaseDirectory(base).application_file(name)
    again = act.Save(asked.doc, asked.name, asked.base, overwrites=True)
    elsewhere = Remedy("Save as…", show=ShowSaveAs())
    if opened.is_partial and not asked.overwrites and opened.opened and opened.opened.path == path:
        lost = next(one.text for one in opened.file_faults if one.level == "fault")
        return No(f"what could not be read of {path} would be lost: {lost}", (elsewhere, Remedy("Overwrite it", again)))
    application = replace(opened.application, name=name)
    try:
        done = BaseDirectory(base).save_application(application, opened.opened, overwrites=asked.overwrites)
    except ValueError as wrong:
        return No(f"{name} cannot be saved: {wrong}")
    if isinstance(done, Refusal):
        return No(plain(done.reason), (*overwriting(done, again), elsewhere))
    if is_running(model, opened.id) and not (opened.opened and opened.opened.path == done.path):
        return _copied(model, opened, done, base)
    saved = replace(opened, application=application, opened=done, base=base, has_changed_on_disk=False)
    saved = replace(saved, file_faults=(), is_partial=False)
    return Done(model.with_application(saved), value=str(done.path))


@on_application
def close(model: Model, opened: OpenApplication, asked: act.Close, _outside: Surroundings) -> Done | No:
    """Close an application; none need be open."""
    if is_running(model, opened.id):
        return running(opened)
    if opened.is_dirty and not asked.discards:
        remedies = (Remedy("Save it first", act.Save(asked.doc)), Remedy("Discard it", act.Close(asked.doc, True)))
        return No(f"{opened.name} is not saved", remedies)
    left = {key: one for key, one in model.applications.items() if key != opened.id}
    return Done(replace(model, applications=left))


@on_resting_application
def reload(model: Model, opened: OpenApplication, _asked: act.Reload, outside: Surroundings) -> Done | No:
    """Take over what stands in the file now, as a step that can be taken back."""
    if opened.opened is None:
        return No(f"{opened.name} has no file yet")
    if model.syntax is None:
        return _no_syntax()
    found = read(str(opened.opened.path), model.syntax, outside)
    if isinstance(found, No):
        return found
    return Done(model.with_application(taken_over(opened, found)), label=READ_AGAIN, doc=opened.id)


@on_application
def keep(model: Model, opened: OpenApplication, _asked: act.Keep, _outside: Surroundings) -> Done | No:
    """Go on with what is here; the next Save finds the file as it was seen now, and overwrites it."""
    file = opened.opened
    content = text.load(file.path, str(file.path))[0] if file else None
    if file is not None and content is not None:
        file = replace(file, text=content)
    return Done(model.with_application(replace(opened, opened=file, has_changed_on_disk=False)))


class Found(NamedTuple):
    """An application as its file says; `is_partial`: as far as it could be read."""

    base: BaseDirectory
    opened: OpenedText[Application]
    faults: Faults
    is_partial: bool


def read(path_or_name: str, syntax: Syntax, outside: Surroundings) -> Found | No:
    """An application by the path of its file or by its name on the search path, with what could not be read of it."""
    path = Path(path_or_name)
    if path.suffix == ".appl":
        if not path.is_file():
            return No(f"{path} is no file" if path.exists() else f"there is no file {path}")
        if path.absolute().parent.name != "appl":
            return No(f"{path} stands in no folder appl/ of a base directory: what it names could not be found")
        base, name = BaseDirectory(path.absolute().parent.parent), path.stem
        if not TASK_NAME.match(name):
            return No(f"{path.name} is no name of an application: expected letters, digits and _ . -, a letter first")
    else:
        name = path_or_name
        bases = [one for one in outside.site.directories if name in one.applications]
        if not bases:
            return No(f"no base directory on the search path has an application {name}")
        base = bases[0]
    found = as_far_as_it_goes(base, name, syntax)
    if isinstance(found, Found):
        return found
    return No(unreadable(path_or_name, found))


def as_far_as_it_goes(base: BaseDirectory, name: str, syntax: Syntax) -> Found | Faults:
    """An application as far as its file can be read; the faults where that is nothing."""
    opened, faults = base.open_application(name, syntax)
    if opened is not None:
        return Found(base, opened, faults, False)
    opened, faults = base.salvage_application(name, syntax)
    return faults if opened is None else Found(base, opened, faults, True)


def taken_over(here: OpenApplication, found: Found) -> OpenApplication:
    """With what stands in its file; every step gets a number that was never used here."""
    application, last = numbered(found.opened.value, here.last_number)
    return replace(
        here,
        application=application,
        last_number=last,
        opened=replace(found.opened, value=application),
        has_changed_on_disk=False,
        file_faults=told(application, found.faults, is_partial=found.is_partial),
        is_partial=found.is_partial,
    )


def _copied(model: Model, opened: OpenApplication, saved: OpenedText[Application], base: Path) -> Done:
    """The copy of one that runs is open beside it, to be changed; what runs stays what it is."""
    number = model.opened + 1
    copy = OpenApplication(f"a{number}", saved.value, opened.last_number, opened=saved, base=base)
    text = f"{copy.name} is open beside {opened.name}, and can be changed"
    done = replace(model.with_application(copy), opened=number)
    return Done(done, value=str(saved.path), says=(page.Say("info", text, copy.id),))


def _shipped(asked: act.Save, name: str, own: Path | None) -> No:
    """What comes with Onika is not changed by the way."""
    here = () if own is None else (Remedy(f"Save a copy in {own}", act.Save(asked.doc, name, str(own))),)
    meant = Remedy("Change the shipped one", act.Save(asked.doc, asked.name, asked.base, overwrites=True))
    return No(f"{name} would be part of Onika itself there", (*here, Remedy("Save as…", show=ShowSaveAs()), meant))


def _no_syntax() -> No:
    return No("there are no types of icons: the definition OnikaUpperSetUp.dta could not be read")
