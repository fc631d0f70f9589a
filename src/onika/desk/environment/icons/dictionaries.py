"""Acts on dictionaries: open and close; and how they follow their files (requirements D01, D15)."""

from collections.abc import Iterable, Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.dictionary import has_dictionary, open_dictionaries
from onika.desk.environment.state.model import Model
from onika.files import onk
from onika.store.base_directory import BaseDirectory
from onika.store.search_path import with_base
from onika.store.site import Site
from onika.store.user_path import user_path
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import Reason, reason_of


def open_dictionary(model: Model, command: act.OpenDictionary, outside: Services) -> Done | No:
    """Open the dictionary of a base directory, named itself or by its `dict/`; one that is open already is shown."""
    path = user_path(command.path, outside.site.own)
    if isinstance(path, Reason):
        return No(Reason.of("desk.path_unopened", path=command.path, why=path), fields={"path": path})
    try:
        path = path.parent if path.name == "dict" and path.is_dir() else path
        whole = path.resolve()
        refused = _no_dictionary(path)
    except (OSError, RuntimeError) as error:  # no access, or links that lead to themselves
        return No(
            Reason.of("desk.path_unopened", path=command.path, why=reason_of(error)), fields={"path": reason_of(error)}
        )
    if refused:
        return refused
    dictionary = next(
        (dictionary for dictionary in model.dictionaries if dictionary.base.path.resolve() == whole), None
    )
    if dictionary is not None:
        return Done(model, value=str(dictionary.base.path))
    done = rearranged(model, in_order(model, BaseDirectory(path), outside.site), frozenset())
    return replace(done, value=str(path))


def close_dictionary(model: Model, command: act.CloseDictionary, _outside: Services) -> Done | No:
    """Close a dictionary; what is placed of it stays, and names that it kept from later ones are theirs."""
    left = [dictionary.base for dictionary in model.dictionaries if str(dictionary.base.path) != command.dictionary]
    if len(left) == len(model.dictionaries):
        return No(Reason.of("desk.dictionary_closed", dictionary=command.dictionary))
    return rearranged(model, left, frozenset())


def reread(model: Model, changed: Set[Path]) -> Done:
    """With files of the open dictionaries read again, and those opened that have come into being on the search path."""
    icons = [path for path in changed if is_icon(path)]
    if not icons:
        return Done(model)
    bases = [dictionary.base for dictionary in model.dictionaries]
    for home in sorted({path.parent.parent for path in icons}):
        if home in model.search and BaseDirectory(home) not in bases and _is_new(BaseDirectory(home), changed):
            bases = with_base(bases, BaseDirectory(home), model.search)
    return rearranged(model, bases, changed)


def shown_at_once(model: Model, path: Path, site: Site) -> Model:
    """With an icon that was saved or removed here; its dictionary is opened where it is on the search path."""
    base = BaseDirectory(path.parent.parent)
    bases: Iterable[BaseDirectory] = (dictionary.base for dictionary in model.dictionaries)
    if _is_on(site, base) and not any(dictionary.base == base for dictionary in model.dictionaries):
        bases = in_order(model, base, site)
    return rearranged(model, bases, {path}).model


def rearranged(model: Model, bases: Iterable[BaseDirectory], changed: Set[Path]) -> Done:
    """With the dictionaries of these base directories, files among `changed` read again; the same model if all is so.

    Faults that were not told yet are.
    """
    if model.syntax is None:
        return Done(model)
    former = model.dictionaries
    dictionaries = open_dictionaries(bases, model.syntax, former, frozenset(changed))
    if len(dictionaries) == len(former) and all(new is old for new, old in zip(dictionaries, former, strict=True)):
        return Done(model)
    faults = {fault for dictionary in former for fault in dictionary.faults}
    news = tuple(fault for dictionary in dictionaries for fault in dictionary.faults if fault not in faults)
    return Done(replace(model, dictionaries=dictionaries), says=told(news))


def in_order(model: Model, base: BaseDirectory, site: Site) -> list[BaseDirectory]:
    """The base directories of the open dictionaries and one more: where the search path has it, else last."""
    return with_base(
        [dictionary.base for dictionary in model.dictionaries], base, [directory.path for directory in site.directories]
    )


def is_icon(path: Path) -> bool:
    """Whether a path is one where a base directory has its icons."""
    return path.suffix == onk.ENDING and path.parent.name == "dict"


def _is_new(base: BaseDirectory, changed: Set[Path]) -> bool:
    """Whether everything in a dictionary has come just now: one that was closed has icons that were there before."""
    return all(base.onikon_file(name) in changed for name in base.onikons)


def _is_on(site: Site, base: BaseDirectory) -> bool:
    return any(directory.path.resolve() == base.path.resolve() for directory in site.directories)


def _no_dictionary(path: Path) -> No | None:
    """Why a path is none of a dictionary, if so."""
    if not path.is_dir():
        shown = str(path)
        is_file = path.exists()
        reason = (
            Reason.of("desk.not_a_directory", path=shown) if is_file else Reason.of("desk.path_missing", path=shown)
        )
        return No(reason, fields={"path": reason})
    if has_dictionary(BaseDirectory(path)):
        return None
    reason = Reason.of("desk.no_dictionary", path=str(path))
    below = sorted(path for path in path.iterdir() if (path / "dict").is_dir())[:3]
    remedies = tuple(_opening(str(path)) for path in below)
    return No(reason, remedies, {"path": reason})


def _opening(path: str) -> Remedy:
    return Remedy(Reason.of("desk.open_dictionary", path=path), act.OpenDictionary(path))
