"""Acts on copies of the user's own that stand before shipped files, and on texts that were replaced (X10, B07)."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import libraries
from onika.desk.environment.file.file_acts import KINDS
from onika.desk.environment.file.file_kind import FileReading
from onika.desk.environment.icons.dictionaries import is_icon, shown_at_once
from onika.desk.environment.outcome.on_file import busy
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.refresh import refreshed, with_own_copies
from onika.desk.environment.state.model import Model
from onika.files import text, whole
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import put
from onika.store.own_copy import OwnCopy, gone_back, own_copy
from onika.store.replaced_texts import ReplacedText, ReplacedTexts
from onika.wire import act, page
from onika.wire.view import ReplacedView, TwoTextsView
from onika.words.fault import Refusal
from onika.words.reason import Reason


def compare_with_shipped(model: Model, command: act.CompareWithShipped, outside: Services) -> Done | No:
    """What the user's own says and what the shipped one says; the value is a `view.TwoTextsView`."""
    copy = own_copy(Path(command.path), outside.site)
    if copy is None:
        return _no_copy(command.path)
    both = copy.texts()
    if isinstance(both, Refusal):
        return No(both.reason)
    return Done(model, value=TwoTextsView(str(copy.own), both[0], str(copy.shipped), both[1]))


def go_back_to_shipped(model: Model, command: act.GoBackToShipped, outside: Services) -> Done | No:
    """The shipped file counts again, also where it is open; what the copy held can be brought back."""
    copy = own_copy(Path(command.path), outside.site)
    if copy is None:
        return _no_copy(command.path)
    if outside.state is None:
        return No(Reason.of("desk.nowhere_to_keep", path=command.path))
    for file in model.open_files:
        refused = busy(model, file) if file.opened and file.opened.path == copy.own else None
        if refused is not None:
            return refused
    changed = gone_back(copy, outside.site, ReplacedTexts(outside.state), outside.calendar())
    if isinstance(changed, Refusal):
        return No(changed.reason)
    step = _reopened(model, copy)
    done = replace(_followed(step.model, changed, outside), label=step.label, doc=step.doc)
    says = page.Say("success", Reason.of("desk.gone_back", path=str(copy.own), base=copy.laboratory))
    return replace(done, value=str(copy.shipped), says=(*done.says, says))


def replaced(model: Model, _command: act.ListReplaced, outside: Services) -> Done | No:
    """The texts that can be brought back."""
    texts = () if outside.state is None else ReplacedTexts(outside.state).listed()
    return Done(model, value=tuple(map(_view, texts)))


def bring_back(model: Model, command: act.BringBack, outside: Services) -> Done | No:
    """Put a replaced text where it was, and keep what stands there now."""
    texts = None if outside.state is None else ReplacedTexts(outside.state)
    former = texts.find(command.number) if texts else None
    if texts is None or former is None:
        return No(Reason.of("desk.nothing_to_bring_back"))
    path = Path(former.path)
    present = text.load(path, former.path)[0] if path.exists() else ""
    if present is None:
        return No(Reason.of("store.not_kept", path=former.path, why=Reason.of("desk.not_readable_now")))
    refused = texts.keep(path, present, outside.calendar()) if present and present != former.text else None
    if refused is not None:
        return No(refused.reason)
    expected = whole.stamp(present) if path.exists() else whole.ABSENT
    written = put(path, former.text, former.text, expected)
    if isinstance(written, Refusal):
        return No(written.reason)
    done = _followed(model, (path,), outside)
    says = page.Say("success", Reason.of("desk.brought_back", path=former.path))
    return replace(done, value=former.path, says=(*done.says, says))


def _followed(model: Model, changed: Iterable[Path], outside: Services) -> Done:
    """With libraries, dictionaries and open files as these files are now; new base directories open in their places."""
    paths = set(changed)
    done = libraries.saved_here(model, {path for path in paths if path.parent.name == "module"})
    now = done.model
    for path in sorted(path for path in paths if is_icon(path)):
        now = shown_at_once(now, path, outside.site)
    rest = refreshed(now, paths, outside.site)
    return replace(rest, model=with_own_copies(rest.model, outside.site), says=(*done.says, *rest.says))


def _reopened(model: Model, copy: OwnCopy) -> Done:
    """With the shipped file in place of the copy where that is open, as a step that can be taken back."""
    home = BaseDirectory(copy.shipped.parent.parent)
    file = next((file for file in model.open_files if file.opened and file.opened.path == copy.own), None)
    if file is None:
        return Done(model)
    reading = KINDS[file.kind].read_again(model, home, copy.shipped.stem)
    if not isinstance(reading, FileReading):
        return Done(model)
    done = KINDS[file.kind].reread(model, file, reading)
    reread = done.model.file(file.id)
    return done if reread is None else replace(done, model=done.model.with_file(replace(reread, base=home.path)))


def _view(former: ReplacedText) -> ReplacedView:
    path = Path(former.path)
    is_there = path.is_file() and text.load(path, former.path)[0] == former.text
    return ReplacedView(former.number, former.path, former.moment_s, former.text.count("\n"), is_there)


def _no_copy(path: str) -> No:
    return No(Reason.of("desk.no_own_copy", path=path))
