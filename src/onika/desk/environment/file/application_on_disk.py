"""The file of an open application, changed by somebody else: taken over where that loses nothing, else told (X10)."""

from collections.abc import Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.file.applications import READ_AGAIN, Found, as_far_as_it_goes, taken_over
from onika.desk.environment.outcome.on_application import is_running
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Change, OpenApplication
from onika.files import text
from onika.store.base_directory import BaseDirectory
from onika.wire import page


def refreshed(model: Model, changed: Set[Path]) -> Done:
    """With the open applications as their files are now; the same model where the files say what was known."""
    says: list[page.Say] = []
    for opened in model.applications.values():
        if opened.opened is not None and opened.opened.path in changed:
            now, said = _looked(model, opened, opened.opened.path, opened.opened.text)
            says += said
            model = model if now is opened else model.with_application(now)
    return Done(model, says=tuple(says))


def _looked(model: Model, opened: OpenApplication, path: Path, known: str) -> tuple[OpenApplication, list[page.Say]]:
    """What is not saved here, or runs, is never touched."""
    if not path.is_file():
        said = f"{path} was removed; {opened.name} is still here and can be saved again"
        return _differs(opened), [page.Say("warning", said, opened.id)]
    if text.load(path, str(path))[0] == known:
        return (replace(opened, has_changed_on_disk=False) if opened.has_changed_on_disk else opened), []
    if opened.is_dirty or is_running(model, opened.id):
        said = f"{opened.name} was changed on the disk by somebody else; what is here stays until you read it again"
        return _differs(opened), [page.Say("warning", said, opened.id)]
    found = as_far_as_it_goes(BaseDirectory(path.parent.parent), path.stem, model.syntax) if model.syntax else ()
    if not isinstance(found, Found):
        said = f"{opened.name} was changed by somebody else and cannot be read now"
        return _differs(opened), [page.Say("warning", said, opened.id)]
    now = taken_over(opened, found)
    change = Change(READ_AGAIN, "", opened.application, now.application)
    said = f"{opened.name} was changed on the disk by somebody else and is read again"
    say = page.Say("warning" if found.is_partial else "info", said, opened.id)
    return replace(now, history=opened.history.done(change)), [say]


def _differs(opened: OpenApplication) -> OpenApplication:
    return opened if opened.has_changed_on_disk else replace(opened, has_changed_on_disk=True)
