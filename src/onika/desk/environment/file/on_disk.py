"""The files of what is open, changed by somebody else: taken over where that loses nothing, else told (X10)."""

from collections.abc import Set
from pathlib import Path

from onika.desk.environment.file.file_acts import KINDS
from onika.desk.environment.file.file_kind import FileReading
from onika.desk.environment.outcome.on_file import AnyFile
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.files import text
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults
from onika.wire import page
from onika.words.reason import Reason


def refreshed(model: Model, changed: Set[Path]) -> tuple[Model, list[page.Say], Faults]:
    """With what is open as its files are now, and the faults that are told thereby.

    The same model where the files say what was known.
    """
    says: list[page.Say] = []
    faults: Faults = ()
    for file in model.open_files:
        if file.opened is not None and file.opened.path in changed:
            now, lines, wrong = _refreshed(model, file, file.opened.path, file.opened.text)
            says += lines
            faults = (*faults, *wrong)
            model = model if now is file else model.with_file(now)
    return model, says, faults


def _refreshed(model: Model, file: AnyFile, path: Path, former: str) -> tuple[AnyFile, list[page.Say], Faults]:
    """What is not saved here, lives or runs, is never touched."""
    kind, name = KINDS[file.kind], file.name
    if not path.is_file():
        line = Reason.of("run.was_removed", path=str(path), name=name)
        return file.differing(True), [page.Say("warning", line, file.id)], ()
    if text.load(path, str(path))[0] == former:
        return file.differing(False), [], ()
    reading = kind.read_again(model, BaseDirectory(path.parent.parent), path.stem)
    if not isinstance(reading, FileReading):
        line = Reason.of("run.changed_by_other", name=name, what=kind.at_fault(reading))
        faults = reading if file.kind is DocumentKind.CONFIGURATION else ()
        return file.differing(True), [page.Say("warning", line, file.id)], faults
    if file.is_unsaved or kind.is_in_use(model, file):
        line = Reason.of("run.changed_stays", name=name)
        return file.differing(True), [page.Say("warning", line, file.id)], ()
    now = kind.refreshed(file, reading, model.next_step)
    line = Reason.of("run.changed_read_again", name=name)
    return now, [page.Say("warning" if reading.is_partial else "info", line, file.id)], ()
