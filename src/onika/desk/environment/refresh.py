"""What others have changed on the disk is taken over where that loses nothing, and told where it would (C01, X10)."""

from collections.abc import Iterable, Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import libraries
from onika.desk.environment.file import file_index, on_disk
from onika.desk.environment.icons import dictionaries, syntax as defining
from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.outcome.staleness import says_otherwise
from onika.desk.environment.reconcile.task_plan import code_of
from onika.desk.environment.state.arrangements import with_arrangements
from onika.desk.environment.state.live import TaskFacts
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files import rmod, syntax
from onika.store.opened_text import Faults
from onika.store.own_copy import own_copies
from onika.store.site import Site
from onika.wire import page
from onika.wire.view import ShowTask
from onika.words.reason import Reason

_TOUCHED = 64
"""Files that are noted; a page shows one."""


def refreshed(model: Model, changed: Set[Path], site: Site | None = None) -> Done:
    """With libraries, dictionaries, lists and open documents as the files are now; `site` is where the syntax is found.

    The same model where the files say what was known: what was saved here is nothing new.
    """
    done = libraries.reread(model, changed)
    former, model, says = model, done.model, [*done.says]
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
    model, says = _touched(former, model, changed), [*says, *_living(model, changed)]
    return Done(model, orders=done.orders, says=(*says, *lines, *told(faults)))


def _touched(former: Model, model: Model, changed: Set[Path]) -> Model:
    """With the files noted that somebody may be looking at; the newest are kept."""
    in_modules = (path for path in changed if path.suffix in (rmod.ENDING, ".py"))
    paths = sorted(str(path) for path in in_modules if not _is_known(path, former, model))
    if not paths:
        return model
    number = max(model.touched.values(), default=0) + 1
    kept = {path: count for path, count in model.touched.items() if path not in paths}
    return replace(model, touched=dict([*kept.items(), *((path, number) for path in paths)][-_TOUCHED:]))


def _is_known(path: Path, former: Model, model: Model) -> bool:
    """Whether a file of a task says what it said before."""
    before, now = former.libraries.records.get(path.stem), model.libraries.records.get(path.stem)
    return path.suffix == rmod.ENDING and before is not None and before is now


def _living(model: Model, changed: Set[Path]) -> Iterable[page.Say]:
    """What is asked of tasks that live with other files than there are now."""
    for document in model.documents.values():
        libraries = model.libraries_of(document)
        for name, facts in document.live.tasks.items() if document.live is not None else ():
            reason = _behind(name, facts, libraries, changed) if name in libraries.tasks else None
            if reason is not None:
                yield page.Say("warning", reason, document.id, ShowTask(name))


def _behind(name: str, facts: TaskFacts, libraries: OpenLibraries, changed: Set[Path]) -> Reason | None:
    task, file, path = libraries.tasks[name], libraries.task_file(name), libraries.code_file(name)
    if facts.planned is None:
        return None
    if file in changed and says_otherwise(facts.planned, task):
        return Reason.of("run.lives_as_filed_before", task=name, path=str(file))
    if path is None or path not in changed or not facts.planned.digest:  # or its code is the runtime's own
        return None
    code = code_of(task.module, libraries, name)
    is_same = not isinstance(code, Reason) and code.digest == facts.planned.digest
    return None if is_same else Reason.of("run.lives_with_older_code", task=name, path=str(path))


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
