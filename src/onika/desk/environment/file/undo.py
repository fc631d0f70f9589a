"""Steps, Undo and Redo: an open file as it was, and what is wanted of the running system where a step changed it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from onika.desk.environment.outcome import pin_changes
from onika.desk.environment.outcome.clash import clashes, refused
from onika.desk.environment.outcome.on_file import AnyFile, busy, on_file
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state import task_edit
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import Edits, FileState, History, UndoStep
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.application import Application
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import Reason


@on_file
def undo(model: Model, file: AnyFile, command: act.Undo, _outside: Services) -> Done | No:
    """Take the last step of a file back."""
    refused_ = busy(model, file)
    if refused_ is not None:
        return refused_
    if file.history.last is None:
        return No(Reason.of("run.nothing_to_undo"))
    if isinstance(file, OpenApplication):
        return _application(model, file, file.history.undone(model.next_step), is_undo=True)
    return _undone(model, file, file.history.last, command)


@on_file
def redo(model: Model, file: AnyFile, command: act.Redo, _outside: Services) -> Done | No:
    """Do the step of a file again that was taken back last."""
    refused_ = busy(model, file)
    if refused_ is not None:
        return refused_
    if file.history.next is None:
        return No(Reason.of("run.nothing_to_redo"))
    if isinstance(file, OpenApplication):
        return _application(model, file, file.history.redone(model.next_step), is_undo=False)
    return _redone(model, file, file.history.next, command)


def stepped(before: Model, done: Done, by: str, command: act.AnyAct) -> Model:
    """With one more step in the history of what was changed, as `done` says; taking back is none."""
    if done.own is not None:
        return replace(done.model, own=done.model.own.done(replace(done.own, by=by, number=before.next_step)))
    old, new = before.file(done.doc), done.model.file(done.doc)
    if not done.label or isinstance(command, act.Undo | act.Redo):
        return done.model
    if isinstance(old, OpenApplication) and isinstance(new, OpenApplication):
        if old.application is new.application:
            return done.model
        change = UndoStep(done.label, by, old.application, new.application, before.next_step)
        return done.model.with_application(replace(new, history=new.history.done(change)))
    if not isinstance(old, Document) or not isinstance(new, Document):
        return done.model
    edited = edits_between(before.libraries, done.model.libraries)
    if old.content == new.content and not edited:
        return done.model
    backwards = edits_between(done.model.libraries, before.libraries)
    step = UndoStep(
        done.label,
        by,
        old.content,
        new.content,
        before.next_step,
        backwards,
        edited,
        before.libraries,
        done.model.libraries,
    )
    if isinstance(command, act.OpenInPlace | act.SwitchTo):
        step = replace(step, file_before=FileState(old.opened, old.base), file_after=FileState(new.opened, new.base))
    return done.model.with_document(replace(new, history=new.history.done(step)))


def edits_between(before: OpenLibraries, after: OpenLibraries) -> dict[str, Task | None]:
    """What was changed of tasks of the libraries: each as it is after; None: it is in none."""
    if before.edits is after.edits:
        return {}
    names = {*before.edits, *after.edits}
    return {name: _now(name, after) for name in names if _meaning(_now(name, before)) != _meaning(_now(name, after))}


def _now(name: str, libraries: OpenLibraries) -> Task | None:
    if name in libraries.edits:
        return libraries.edits[name]
    return libraries.filed(name)


def _meaning(task: Task | None) -> Task | None:
    """A task but for its rate, which is no edit: one that was saved with its rate is what it was."""
    return replace(task, frequency=None) if task else None


def moved_wanted(now: Mapping[str, bool], start: Content, end: Content) -> dict[str, bool]:
    """What is wanted now, with the difference between two contents applied to it."""
    wanted = dict(now)
    for name in {*start.wanted, *end.wanted}:
        if start.wanted.get(name) == end.wanted.get(name):
            continue
        if name in end.wanted:
            wanted[name] = end.wanted[name]
        else:
            wanted.pop(name, None)
    return wanted


@dataclass(frozen=True, slots=True)
class _Way:
    """From one end of a step to the other."""

    step: UndoStep[Content]
    start: Content
    end: Content
    edits_start: Edits
    edits_end: Edits
    libraries: OpenLibraries | None
    """What the loci of the end were settled with."""
    file: FileState | None
    """The file of the end, where it is another one."""

    def edits(self, now: OpenLibraries) -> dict[str, Task | None]:
        """The tasks as they are now, with the difference between the two ends applied to them."""
        return {name: self._moved(name, task, now) for name, task in self.edits_end.items()}

    def _moved(self, name: str, end: Task | None, now: OpenLibraries) -> Task | None:
        start, task = self.edits_start.get(name), now.tasks.get(name)
        if end and start and task:
            return task_edit.rebased(end, start, task)
        return end


def _undone(model: Model, document: Document, step: UndoStep[Content], command: act.Undo) -> Done | No:
    risk = _comes_on(document, step.after, step.before)
    if risk and not command.confirmed:
        meant = act.Undo(command.doc, confirmed=True)
        reason = Reason.of("run.undo_turns_on", step=step.label, names=risk)
        return No(reason, (Remedy(Reason.of("desk.go_on"), meant),))
    way = _Way(
        step, step.after, step.before, step.edits_after, step.edits_before, step.libraries_before, step.file_before
    )
    cannot = Reason.of("run.not_undone", step=step.label)
    return _restored(model, document, way, document.history.undone(model.next_step), cannot)


def _redone(model: Model, document: Document, step: UndoStep[Content], command: act.Redo) -> Done | No:
    risk = _comes_on(document, step.before, step.after)
    if risk and not command.confirmed:
        meant = act.Redo(command.doc, confirmed=True)
        reason = Reason.of("run.redo_turns_on", step=step.label, names=risk)
        return No(reason, (Remedy(Reason.of("desk.go_on"), meant),))
    way = _Way(
        step, step.before, step.after, step.edits_before, step.edits_after, step.libraries_after, step.file_after
    )
    cannot = Reason.of("run.not_redone", step=step.label)
    return _restored(model, document, way, document.history.redone(model.next_step), cannot)


def _application(model: Model, opened: OpenApplication, history: History[Application], *, is_undo: bool) -> Done:
    """As it was, but for its name: that is of the file."""
    step = history.future[-1] if is_undo else history.past[-1]
    content = step.before if is_undo else step.after
    application = content if content.name == opened.name else replace(content, name=opened.name)
    opened = replace(opened, application=application, history=history)
    return Done(model.with_application(opened), step.label, opened.id, value=step.label)


def _restored(model: Model, document: Document, way: _Way, history: History[Content], cannot: Reason) -> Done | No:
    wanted = moved_wanted(document.content.wanted, way.start, way.end) if document.live else {}
    names = set(way.end.union)
    wanted = {name: is_on for name, is_on in wanted.items() if name in names}
    if document.live:
        wanted = {**dict.fromkeys(sorted(names), False), **wanted}
    libraries = model.libraries.edited(way.edits(model.libraries)) if way.edits_end else model.libraries
    content = Content(way.end.configuration, wanted, way.end.kept if document.live else ())
    content = pin_changes.settled(content, way.libraries or libraries, libraries)
    restored = replace(document, content=content, history=history)
    if way.file is not None:
        restored = replace(restored, opened=way.file.opened, base=way.file.base)
    against = clashes(model.with_document(restored), libraries, way.edits_end)
    if against:
        return refused(cannot, against)
    others = pin_changes.resettled(replace(model.without(document.id), libraries=libraries), model.libraries)
    documents = {key: others.documents.get(key, restored) for key in model.documents}
    return Done(replace(others, documents=documents), way.step.label, document.id, value=way.step.label)


def _comes_on(document: Document, start: Content, end: Content) -> tuple[str, ...]:
    """The tasks that would come ON in the running system."""
    if document.live is None:
        return ()
    now = document.content.wanted
    after = moved_wanted(now, start, end)
    return tuple(sorted(name for name, is_on in after.items() if is_on and not now.get(name)))
