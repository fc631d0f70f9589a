"""Acts on files that are, or are to be, open: open, save, close, read again, keep (requirements C06, C21, D04, X10).

Configurations and applications differ in how they are read, written and taken over (`file_kind`).
"""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from onika.desk.environment.file.applications import Applications
from onika.desk.environment.file.configurations import Configurations
from onika.desk.environment.file.file_kind import FileKind
from onika.desk.environment.outcome.on_file import AnyFile, busy, on_file
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting
from onika.desk.environment.outcome.replacing import kept, present_text
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.files import appl, conf, text
from onika.store.own_copy import saving_place
from onika.store.user_path import user_path
from onika.wire import act, page
from onika.wire.view import Remedy, ShowSaveAs
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

KINDS: Mapping[DocumentKind, FileKind[Any, Any]] = {
    DocumentKind.CONFIGURATION: Configurations(),
    DocumentKind.APPLICATION: Applications(),
}


def open_file(model: Model, command: act.Open, outside: Services) -> Done | No:
    """Open a file beside the others; one that is open already is shown. The value is its id."""
    kind = KINDS[_kind(command.path, outside)]
    reading = kind.read(model, command.path, outside)
    if isinstance(reading, No):
        return reading
    for file in model.open_files:
        if file.opened and file.opened.path == reading.opened.path:
            return Done(model, value=file.id)
    return kind.open(model, reading)


@on_file
def save(model: Model, file: AnyFile, command: act.Save, outside: Services) -> Done | No:
    """Save an open file; the value is its path."""
    kind, name = KINDS[file.kind], command.name or file.name
    if not TASK_NAME.match(name):
        form = Reason.of("run.file_name_form")
        return No(Reason.of("run.no_file_name", name=name), fields={"name": Reason.of("run.expected", form=form)})
    own = outside.site.own
    base = user_path(command.base, own) if command.base else file.base or (own if command.name else None)
    if isinstance(base, Reason):
        return No(base, fields={"base": base})
    if base is None:
        return No(Reason.of("run.save_nowhere"), (_elsewhere(),))
    home = saving_place(base, outside.site)
    if isinstance(home, Refusal):
        return No(home.reason, (_elsewhere(),))
    again = act.Save(command.doc, command.name, command.base, overwrites=True)
    loss = kind.loss(file, kind.path(home, name))
    if loss and not command.overwrites:
        return No(loss, (_elsewhere(), Remedy(Reason.of("desk.overwrite_it"), again)))
    former = present_text(kind.path(home, name))
    file = kind.as_seen(model, file)
    opened = kind.write(home, name, file, overwrites=command.overwrites)
    if isinstance(opened, No):
        return opened
    if isinstance(opened, Refusal):
        return No(opened.reason, (*overwriting(opened, again), _elsewhere()))
    done = kind.saved(model, file, opened, home.path)
    done = replace(done, says=(*done.says, *_differences(done.model, file, home.path, outside)))
    done = replace(done, says=(*done.says, *kept(opened.path, former, outside)))
    copied = page.Say("success", Reason.of("desk.saved_as_own", path=str(opened.path), base=base.name), file.id)
    return done if home.path == base else replace(done, says=(*done.says, copied))


def _differences(model: Model, file: AnyFile, home: Path, outside: Services) -> tuple[page.Say, ...]:
    """What is told of a saved file that another program would read differently."""
    others = KINDS[file.kind].elsewhere(model, file, home, outside.site)
    return tuple(page.Say("warning", reason, file.id) for reason in others)


@on_file
def close(model: Model, file: AnyFile, command: act.Close, _outside: Services) -> Done | No:
    """Close an open file."""
    refused = busy(model, file)
    if refused is not None:
        return refused
    if file.is_unsaved and not command.discards:
        save_first = Remedy(Reason.of("run.save_first"), act.Save(command.doc))
        discard = Remedy(Reason.of("run.discard"), act.Close(command.doc, True))
        return No(Reason.of("run.is_not_saved", name=file.name), (save_first, discard))
    return KINDS[file.kind].close(model, file, command.alive, discards=command.discards)


@on_file
def reload(model: Model, file: AnyFile, _command: act.Reload, outside: Services) -> Done | No:
    """Take over what stands in the file now, as a step that can be taken back."""
    refused = busy(model, file)
    if refused is not None:
        return refused
    if file.opened is None:
        return No(Reason.of("run.has_no_file", name=file.name))
    reading = KINDS[file.kind].read(model, str(file.opened.path), outside)
    if isinstance(reading, No):
        return reading
    return KINDS[file.kind].reread(model, file, reading)


@on_file
def keep(model: Model, file: AnyFile, _command: act.Keep, _outside: Services) -> Done | No:
    """Go on with what is here; the next Save finds the file as it was seen now, and overwrites it."""
    file = file.differing(False)
    content = text.load(file.opened.path, str(file.opened.path))[0] if file.opened else None
    if content is None:
        return Done(model.with_file(file))
    return Done(model.with_file(file.seen(content)))


def _kind(path_or_name: str, outside: Services) -> DocumentKind:
    """The ending says what is opened; of a name alone a configuration, else an application."""
    ending, bases = Path(path_or_name).suffix, outside.site.directories
    if ending in (appl.ENDING, conf.ENDING):
        if ending == appl.ENDING:
            return DocumentKind.APPLICATION
        return DocumentKind.CONFIGURATION
    is_configuration = any(path_or_name in base.configurations for base in bases)
    is_application = any(path_or_name in base.applications for base in bases)
    if is_application and not is_configuration:
        return DocumentKind.APPLICATION
    return DocumentKind.CONFIGURATION


def _elsewhere() -> Remedy:
    return Remedy(Reason.of("desk.save_as"), show=ShowSaveAs())
