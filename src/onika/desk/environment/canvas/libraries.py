"""Libraries come, go, and are read again; what was changed of their tasks stays changed (requirements C01, C04)."""

from collections.abc import Iterable, Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.file import file_index
from onika.desk.environment.outcome import pin_changes
from onika.desk.environment.outcome.clash import clashes
from onika.desk.environment.outcome.code_faults import rewritten
from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.descriptions import forgotten
from onika.desk.environment.state import task_edit
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.rules import placement
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import Library, reopen_libraries
from onika.store.search_path import with_base
from onika.store.user_path import user_path
from onika.wire import act, page
from onika.wire.view import Remedy
from onika.words.reason import Reason, reason_of

_FOLDERS = ("module", "conf", "dict", "appl")


def open_library(model: Model, command: act.OpenLibrary, outside: Services) -> Done | No:
    """Open a base directory behind the others; one that is open already is shown."""
    path = user_path(command.path, outside.site.own)
    if isinstance(path, Reason):
        return No(Reason.of("desk.path_unopened", path=command.path, why=path), fields={"path": path})
    try:
        whole = path.resolve()
        refused = _no_base(path)
    except (OSError, RuntimeError) as error:  # no access, or links that lead to themselves
        return No(
            Reason.of("desk.path_unopened", path=command.path, why=reason_of(error)), fields={"path": reason_of(error)}
        )
    if refused:
        return refused
    library = next((library for library in model.libraries.libraries if library.base.path.resolve() == whole), None)
    if library is not None:
        return Done(model, value=str(library.base.path))
    base = BaseDirectory(path)
    done = rearranged(model, (*(library.base for library in model.libraries.libraries), base), frozenset())
    listed = file_index.listed([base], model.syntax)
    return replace(done, model=listed.beside(done.model), value=str(path), says=(*done.says, *told(listed.faults)))


def close_library(model: Model, command: act.CloseLibrary, _outside: Services) -> Done | No:
    """Close a library; what is placed of it stays, and what was changed of its tasks comes back with it."""
    bases = [library.base for library in model.libraries.libraries]
    left = [base for base in bases if str(base.path) != command.library]
    if len(left) == len(bases):
        return No(Reason.of("desk.library_closed", library=command.library))
    done = rearranged(model, left, frozenset())
    return replace(done, model=file_index.without(done.model, file_index.of_base(model, command.library)))


def reread(model: Model, changed: Set[Path]) -> Done:
    """With files of the open libraries read again, and those opened that have come into being on the search path."""
    bases = [library.base for library in model.libraries.libraries]
    for home in sorted({path.parent.parent for path in changed if path.parent.name == "module"}):
        base = BaseDirectory(home)
        if home in model.search and base not in bases and _is_new(base, changed):
            bases = with_base(bases, base, model.search)
    return _read_again(model, bases, changed)


def saved_here(model: Model, changed: Set[Path]) -> Done:
    """With files read again that were written here, and their libraries opened where the search path has them."""
    bases = [library.base for library in model.libraries.libraries]
    for home in sorted({path.parent.parent for path in changed}):
        base = BaseDirectory(home)
        if home in model.search and base not in bases:
            bases = with_base(bases, base, model.search)
    return _read_again(model, bases, changed)


def _read_again(model: Model, bases: Iterable[BaseDirectory], changed: Set[Path]) -> Done:
    done = rearranged(model, bases, changed)
    model = rewritten(done.model, {path for path in changed if path.suffix == ".py"})
    for module in sorted({path.stem for path in changed if path.suffix == ".py"}):
        model = forgotten(model, module)
    return replace(done, model=model)  # what its class declares now is asked by whoever follows


def rearranged(model: Model, bases: Iterable[BaseDirectory], changed: Set[Path]) -> Done:
    """With the libraries of these base directories, files among `changed` read again; the same model if all is as was.

    What was changed here of a task goes onto its new file, and the open documents follow.
    """
    former = model.libraries
    reopened = reopen_libraries(bases, former.libraries, changed)
    if reopened == former.libraries:
        return Done(model)
    rebased, dropped = _rebased(replace(former, libraries=reopened), former, _living(model))
    says = [*_news(former.libraries, reopened), *dropped]
    names = {name for name in rebased.tasks if rebased.tasks[name] != former.tasks.get(name)}
    against = clashes(model, rebased, names & former.tasks.keys())
    says += [page.Say("warning", reason.text) for reason in against]
    return Done(pin_changes.resettled(replace(model, libraries=rebased), former), says=tuple(says))


def _is_new(base: BaseDirectory, changed: Set[Path]) -> bool:
    """Whether everything in a library has come just now: one that was closed has files that were there before."""
    files = (*map(base.task_file, base.tasks), *map(base.code_file, base.modules))
    return all(file in changed for file in files)


def _no_base(path: Path) -> No | None:
    """Why a path is none of a base directory, if so."""
    if not path.is_dir():
        is_file, shown = path.exists(), str(path)
        reason = (
            Reason.of("desk.not_a_directory", path=shown) if is_file else Reason.of("desk.path_missing", path=shown)
        )
        return No(reason, fields={"path": reason})
    if any((path / folder).is_dir() for folder in _FOLDERS):
        return None
    reason = Reason.of("desk.no_base_directory", path=str(path))
    parent = path.parent
    is_part = path.name in _FOLDERS
    remedies = (Remedy(Reason.of("desk.open_file", name=str(parent)), act.OpenLibrary(str(parent))),) if is_part else ()
    return No(reason, remedies, {"path": reason})


def _living(model: Model) -> frozenset[str]:
    """Tasks that are wanted in the running system: a file that somebody else writes changes nothing there."""
    return frozenset(
        placed.file
        for document in model.documents.values()
        if document.live
        for placed in document.content.configuration.placed
        if placed.task in document.content.wanted
    )


def _rebased(
    libraries: OpenLibraries, former: OpenLibraries, living: frozenset[str]
) -> tuple[OpenLibraries, list[page.Say]]:
    """With every change put on its file as that is now; one that does not fit is told and gone."""
    edits: dict[str, Task] = {}
    says = []
    for name, changed in former.edits.items():
        old, new = former.filed(name), libraries.filed(name)
        if new is None or old is new or name in living:
            edits[name] = changed
            continue
        edits[name] = task_edit.carried(changed, new) if old is None else task_edit.rebased(changed, old, new)
        is_other = new.module != changed.module or _is_elsewhere(name, former, libraries)
        if is_other or placement.alias_refusals(edits[name], ()):
            edits[name] = new
            says.append(page.Say("warning", Reason.of("desk.edit_unfit", name=name)))
    return replace(libraries, edits={name: task for name, task in edits.items() if task != libraries.filed(name)}), says


def _is_elsewhere(name: str, former: OpenLibraries, libraries: OpenLibraries) -> bool:
    """Whether another library has another task of that name now; a copy that stands before it is the same."""
    old, new = former.homes.get(name), libraries.homes.get(name)
    if old is None or new is None or old.base == new.base:
        return False
    is_copy = any(library.base == old.base for library in libraries.libraries)
    return not (is_copy and former.records[name].text == libraries.records[name].text)


def _news(former: Iterable[Library], libraries: Iterable[Library]) -> list[page.Say]:
    """Faults that were not told yet."""
    faults = {fault for library in former for fault in library.faults}
    return list(told(fault for library in libraries for fault in library.faults if fault not in faults))
