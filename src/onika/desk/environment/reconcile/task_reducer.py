"""What a runtime tells of a task becomes facts of the document that is connected with its subsystem (law 22)."""

from collections.abc import Callable
from dataclasses import replace

from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.reconcile.current_values import ask_present
from onika.desk.environment.reconcile.live_facts import settled
from onika.desk.environment.reconcile.merge import look_again
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TaskFacts
from onika.desk.environment.state.model import Model
from onika.wire import event, page
from onika.wire.view import ShowTask
from onika.words.reason import NOTHING, Reason

TaskEvent = event.TaskState | event.Failed | event.Asked | event.Warned | event.Signalled


def after_event(model: Model, document: Document, message: TaskEvent) -> Done:
    """The model after a piece of news of a task of a connected document, and what is worth a line."""
    match message:
        case event.TaskState():
            return _turned(model, document, message)
        case event.Failed():
            return _failed(model, document, message)
        case event.Asked():
            return _asked(model, document, message)
        case event.Warned():
            return _warned(model, document, message)
        case event.Signalled():
            return Done(model, says=(_signal(message, document.id),))


def _turned(model: Model, document: Document, message: event.TaskState) -> Done:
    """A task's state has changed; what is wanted follows where nobody here has asked for something else."""
    subsystem_facts = document.live
    if subsystem_facts is None:
        return Done(model)
    facts = subsystem_facts.tasks.get(message.task)
    is_killed = message.state == "KILLED"
    if facts is None:  # somebody else's, or one that is dead already
        if is_killed or subsystem_facts.pending:
            return Done(model)
        return Done(model, orders=(look_again(document.id),))
    if is_killed and facts.state == "SPAWNING":  # the old one of an exchange
        return Done(model)
    now = None if is_killed else _in_state(facts, message.state)
    document = replace(document, live=subsystem_facts.with_task(message.task, now))
    return Done(model.with_document(settled(document)))


def _in_state(facts: TaskFacts, state: str) -> TaskFacts:
    return replace(
        facts,
        state=state,
        note=NOTHING,
        question=facts.question if state == "ASKING" else None,
        present=facts.present if state == "ASKING" else {},
        failed=facts.failed if state == "ERROR" else None,
    )


def _failed(model: Model, document: Document, message: event.Failed) -> Done:
    reason = Reason.of("run.task_failed", task=message.task, why=message.text)
    line = page.Say("error", reason, document.id, ShowTask(message.task), is_quiet=True)
    return Done(_changed(model, document, message.task, lambda facts: replace(facts, failed=message)), says=(line,))


def _asked(model: Model, document: Document, message: event.Asked) -> Done:
    after = _changed(model, document, message.task, lambda facts: replace(facts, question=message))
    return Done(after, orders=ask_present(model, document, message.task))


def _warned(model: Model, document: Document, message: event.Warned) -> Done:
    """A warning of a task is counted; what is of none is only said."""
    if not message.task:
        return Done(model, says=(page.Say("warning", message.text, document.id, None, is_quiet=True),))
    reason = Reason.of("run.what_why", what=message.task, why=message.text)
    line = page.Say("warning", reason, document.id, ShowTask(message.task), is_quiet=True)
    after = _changed(model, document, message.task, lambda facts: replace(facts, warnings=facts.warnings + 1))
    return Done(after, says=(line,))


def _signal(message: event.Signalled, doc: str) -> page.Say:
    task, kind, why, where = message.task, message.kind, message.text, ShowTask(message.task)
    if kind == "FINISH":
        return page.Say("end", Reason.of("run.task_finished", task=task), doc, where, is_quiet=True)
    if why:
        reason = Reason.of("run.task_signals_why", task=task, kind=kind, why=why)
    else:
        reason = Reason.of("run.task_signals", task=task, kind=kind)
    return page.Say("info" if kind == "LEGAL" else "warning", reason, doc, where, is_quiet=True)


def _changed(model: Model, document: Document, task: str, change: Callable[[TaskFacts], TaskFacts]) -> Model:
    """The model with other facts of a task; the same where nothing is known of it."""
    subsystem_facts = document.live
    facts = subsystem_facts.tasks.get(task) if subsystem_facts else None
    if subsystem_facts is None or facts is None:
        return model
    return model.with_document(replace(document, live=subsystem_facts.with_task(task, change(facts))))
