"""Parameter sets of a configuration are kept, compared and switched: all values of a set, or none."""

from collections.abc import Iterator

from onika.desk.environment.canvas.parameters import Lines, faults_by_line, with_parameters
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.replacing import kept as kept_text, present_text
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.restoration import FileText, own_step
from onika.model.parameter import default_words
from onika.model.parameter_set import ParameterSet, Values, merged
from onika.model.task import LocalLine, Task
from onika.store import parameter_set_file
from onika.store.opened_text import OpenedText
from onika.store.parameter_set_file import Sets
from onika.wire import act, page
from onika.wire.sheet import ModuleSheet
from onika.wire.view import ParameterSetsView, ParameterSetView, Remedy, ShowSaveAs
from onika.words.fault import Refusal
from onika.words.reason import Reason

_FIXED = ("DEVICE", "PARTNER", "STARTS")
"""Lines that are no tuning: which device is moved, and which program is talked with."""

_LONGEST = 60
"""Letters of the name of a set."""

_Opened = OpenedText[Sets] | None


@on_document
def list_sets(model: Model, document: Document, _command: act.ListSets, outside: Services) -> Done | No:
    """The sets that are kept, and the parameters as they are now."""
    kept = _kept(document, outside)
    if isinstance(kept, No):
        return kept
    return Done(model, value=_view(model, document, kept[0], kept[1]))


@on_document
def keep_set(model: Model, document: Document, command: act.KeepSet, outside: Services) -> Done | No:
    """Keep the parameters as they are now under a name."""
    name = " ".join(command.name.split())
    if not name or len(name) > _LONGEST or not name.isprintable():
        reason = Reason.of("desk.set_name_form", most=_LONGEST)
        return No(reason, fields={"name": reason})
    values = tuple(_present(model, document))
    if not values:
        return No(Reason.of("desk.no_parameters", name=document.name))
    kept = _kept(document, outside)
    if isinstance(kept, No):
        return kept
    sets = kept[1].value if kept[1] else ()
    if any(other.name == name for other in sets) and not command.overwrites:
        reason = Reason.of("desk.set_there", name=name)
        over = Remedy(Reason.of("desk.set_replace"), act.KeepSet(command.doc, name, overwrites=True))
        return No(reason, (over,), fields={"name": reason})
    new = ParameterSet(name, values)
    others = tuple(new if other.name == name else other for other in sets)
    changed = others if new in others else (*others, new)
    return _written(model, document, kept, changed, Reason.of("desk.keeping_set", name=name), outside)


@on_document
def remove_set(model: Model, document: Document, command: act.RemoveSet, outside: Services) -> Done | No:
    """Keep a set no longer; that is taken back as other changes outside of open files are."""
    kept = _kept(document, outside)
    if isinstance(kept, No):
        return kept
    sets = kept[1].value if kept[1] else ()
    rest = tuple(other for other in sets if other.name != command.name)
    if len(rest) == len(sets):
        return _no_set(document, command.name)
    return _written(model, document, kept, rest, Reason.of("desk.removing_set", name=command.name), outside)


@on_document
def switch_set(model: Model, document: Document, command: act.SwitchSet, outside: Services) -> Done | No:
    """Take all values of a set over, as one step; where one of them is refused nothing changes."""
    kept = _kept(document, outside)
    if isinstance(kept, No):
        return kept
    wanted = next((other for other in (kept[1].value if kept[1] else ()) if other.name == command.name), None)
    if wanted is None:
        return _no_set(document, command.name)
    tasks = model.libraries_of(document).tasks
    here = [name for name in wanted.tasks if document.content.placed(name) and name in tasks]
    lines = {name: merged(tasks[name].local, _differing(model, tasks[name], wanted)) for name in here}
    wrong = dict(_faults(model, document, lines))
    if wrong:
        reason = Reason.of("desk.set_refused", name=command.name, reasons=tuple(wrong.values()))
        return No(reason, fields=wrong)
    changed = {name: new for name, new in lines.items() if new != tasks[name].local}
    absent = tuple(name for name in wanted.tasks if name not in here)
    says = (page.Say("warning", Reason.of("desk.set_tasks_absent", name=command.name, tasks=absent), document.id),)
    now = with_parameters(model, document, changed) if changed else model
    view = _view(now, now.documents[document.id], kept[0], kept[1])
    label = Reason.of("desk.switching_set", name=command.name)
    return Done(now, label, document.id, value=view, says=says if absent else ())


def _kept(document: Document, outside: Services) -> tuple[FileText, _Opened] | No:
    """The file of a configuration's sets as it is, and what it holds."""
    if document.opened is None:
        save = Remedy(Reason.of("desk.save_as"), show=ShowSaveAs())
        return No(Reason.of("desk.set_needs_file", name=document.name), (save,))
    file = document.opened.path
    path = parameter_set_file.place(document.base or file.parent.parent, file.stem, outside.site)
    if isinstance(path, Refusal):
        return No(path.reason)
    opened, faults = parameter_set_file.opened(path)
    if faults:
        return No(faults[0].sentence)
    return FileText.of(path), opened


def _written(
    model: Model, document: Document, kept: tuple[FileText, _Opened], sets: Sets, label: Reason, outside: Services
) -> Done | No:
    """Write the sets; a step that is taken back as other changes outside of open files are."""
    before, opened = kept
    former = present_text(before.path)
    saved = parameter_set_file.kept(before.path, sets, opened)
    if isinstance(saved, Refusal):
        return No(saved.reason)
    step = own_step(label, before, FileText.of(before.path))
    says = kept_text(before.path, former, outside)
    return Done(model, value=_view(model, document, before, saved), says=says, own=step)


def _present(model: Model, document: Document) -> Iterator[tuple[str, LocalLine]]:
    """The parameters of the tasks on a canvas as they are now."""
    for name in document.content.names:
        task = model.libraries_of(document).tasks.get(name)
        if task is not None:
            for line in _lines(task, model.libraries.sheets.get(task.module)):
                yield name, line


def _lines(task: Task, sheet: ModuleSheet | None) -> Iterator[LocalLine]:
    """The parameters of a task; those that its module declares also where they stand in no line."""
    lines = {line.key: line.words for line in task.local}
    declared = {local.name: lines.get(local.name, default_words(local)) for local in sheet.locals} if sheet else lines
    for key, words in declared.items():
        if key not in _FIXED and words:
            yield LocalLine(key, words)


def _differing(model: Model, task: Task, wanted: ParameterSet) -> dict[str, tuple[str, ...]]:
    """What a set changes of a task: a default that is in force needs no line, nor is a task exchanged for it."""
    present = {line.key: line.words for line in _lines(task, model.libraries.sheets.get(task.module))}
    return {key: words for key, words in wanted.of_task(task.name).items() if present.get(key) != words}


def _faults(model: Model, document: Document, lines: dict[str, Lines]) -> Iterator[tuple[str, Reason]]:
    """What is wrong with values, by task and parameter."""
    for name, new in lines.items():
        task = model.libraries_of(document).tasks[name]
        for number, reason in faults_by_line(task, new, model.libraries.sheets.get(task.module)).items():
            yield f"{name} {new[number].key}", Reason.of("run.what_why", what=name, why=reason)


def _view(model: Model, document: Document, file: FileText, opened: _Opened) -> ParameterSetsView:
    sets = opened.value if opened else ()
    views = tuple(ParameterSetView(other.name, _plain(other.values)) for other in sets)
    return ParameterSetsView(str(file.path), views, _plain(tuple(_present(model, document))))


def _plain(values: Values) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
    return tuple((task, line.key, line.words) for task, line in values)


def _no_set(document: Document, name: str) -> No:
    return No(Reason.of("desk.no_set", set=name, name=document.name))
