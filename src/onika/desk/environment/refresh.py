"""What others have changed on the disk is taken over where that loses nothing, and told where it would (C01, X10)."""

from collections.abc import Iterable, Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import libraries
from onika.desk.environment.file import file_index, on_disk
from onika.desk.environment.icons import dictionaries, syntax as defining
from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.arrangements import with_arrangements
from onika.desk.environment.state.model import Model
from onika.files import syntax
from onika.store.opened_text import Faults
from onika.store.own_copy import own_copies
from onika.store.site import Site


def refreshed(model: Model, changed: Set[Path], site: Site | None = None) -> Done:
    """With libraries, dictionaries, lists and open documents as the files are now; `site` is where the syntax is found.

    The same model where the files say what was known: what was saved here is nothing new.
    """
    done = libraries.reread(model, changed)
    model, says = done.model, [*done.says]
    model, faults = _listed(model, sorted(changed))
    icons = dictionaries.reread(model, changed)
    model, says = icons.model, [*says, *icons.says]
    if site is not None and any(syntax.NAME in path.name for path in changed):
        defined = defining.redefined(model, site)
        model, says = defined.model, [*says, *defined.says]
    if site is not None:
        model, wrong_files = with_arrangements(model, site)
        faults = (*faults, *(fault for fault in wrong_files if Path(fault.place.file) in changed))
    model, lines, wrong = on_disk.refreshed(model, changed)
    faults = tuple(fault for fault in faults if fault not in wrong)
    model = model if site is None or not changed else with_own_copies(model, site)
    return Done(model, orders=done.orders, says=(*says, *lines, *told(faults)))


def with_own_copies(model: Model, site: Site) -> Model:
    """With the files that stand before shipped ones as they are now."""
    copies = {str(copy.own): copy.laboratory for copy in own_copies(site)}
    return model if copies == model.own_copies else replace(model, own_copies=copies)


def _listed(model: Model, paths: Iterable[Path]) -> tuple[Model, Faults]:
    """With these configurations and applications in their lists as they are now."""
    listed, gone = file_index.FileIndex(), list[str]()
    for path in paths:
        if not (file_index.is_configuration(path) or file_index.is_application(path)):
            continue
        again = file_index.again(path, model.syntax)
        if again is None:
            gone.append(str(path))
        else:
            listed = listed.and_(again)
    return listed.beside(file_index.without(model, gone)), listed.faults
