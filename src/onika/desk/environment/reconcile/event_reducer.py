"""What a runtime tells becomes facts of documents: states, questions, errors, who holds what (law 22)."""

from dataclasses import replace

import msgspec

from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.reconcile import holders, presence, reconciliation
from onika.desk.environment.reconcile.current_values import ask_present
from onika.desk.environment.reconcile.live_facts import settled
from onika.desk.environment.reconcile.merge import look_again
from onika.desk.environment.reconcile.watches import is_going
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts, TaskFacts
from onika.desk.environment.state.model import Model
from onika.desk.run import transfer_text
from onika.wire import event, page, view
from onika.wire.view import ShowTask


def after_event(model: Model, message: event.Event, at_s: float = 0.0) -> Done:
    """The model after a piece of news, and what is worth a line; `at_s` is seconds since 1970."""
    model = _questioned(model, message)
    match message:
        case event.TaskState() | event.Failed() | event.Asked() | event.Warned() | event.Signalled():
            return _of_task(model, message)
        case event.Stepped() if message.is_too_far:
            return _stepped(model, message)
        case event.Edited():
            return _edited(model, message)
        case event.Result() if not is_going(model):  # of a run that is not of this environment
            return Done(model, orders=(presence.ask_what(),))
        case event.Held() | event.Offered() | event.Company() | event.Moved():
            return _of_holder(model, message, at_s)
        case event.Stopped() | event.Lost() | event.Drive():
            return _of_runtime(model, message)
    return Done(model)


def _edited(model: Model, message: event.Edited) -> Done:
    document = _home(model, message.subsystem)
    if document is None:
        return Done(model)
    return reconciliation.edited(model, document.id, message.number, str(message.cause))


def _of_holder(model: Model, message: event.Held | event.Offered | event.Company | event.Moved, at_s: float) -> Done:
    """Who is there, who holds what, and where the runs of others are."""
    match message:
        case event.Held():
            return _held(model, message, at_s)
        case event.Offered():
            return presence.offered(model, message, at_s)
        case event.Company():
            return presence.came(model, message)
        case event.Moved():
            return Done(replace(model, runtime=holders.moved(model.runtime, message)))


def _of_runtime(model: Model, message: event.Stopped | event.Lost | event.Drive) -> Done:
    """What concerns everybody."""
    match message:
        case event.Stopped():
            return _stopped(model, message)
        case event.Lost():
            return _lost(model, message)
    if message.state not in ("TRIPPED", "PRESSED") or model.runtime.is_stopped:
        return Done(model)
    why = f": {message.cause}" if message.cause else ""
    return Done(model, says=(page.Say("error", f"drive {message.device} is {message.state}{why}"),))


def _questioned(model: Model, message: event.Event) -> Model:
    """What tasks of applications ask, whoever began these."""
    match message:
        case event.Asked():
            return replace(model, runtime=holders.with_question(model.runtime, message))
        case event.TaskState():
            runtime = holders.turned(model.runtime, message)
            if runtime is model.runtime:
                return model
            return replace(model, runtime=runtime)
    return model


_OfTask = event.TaskState | event.Failed | event.Asked | event.Warned | event.Signalled


def _of_task(model: Model, of_task: _OfTask) -> Done:
    document = _home(model, of_task.subsystem)
    if document is None or document.live is None:
        is_new = bool(of_task.subsystem) and of_task.subsystem not in model.runtime.subsystems and not is_going(model)
        return Done(_with_subsystem(model, of_task.subsystem), orders=(presence.ask_what(),) if is_new else ())
    subsystem_facts, facts = document.live, document.live.tasks.get(of_task.task)
    where = ShowTask(of_task.task)

    def done(new: TaskFacts, *messages: page.Say) -> Done:
        new_live = subsystem_facts.with_task(of_task.task, new) if facts else subsystem_facts
        return Done(model.with_document(replace(document, live=new_live)), says=messages)

    match of_task:
        case event.TaskState():
            return _turned(model, document, subsystem_facts, of_task)
        case event.Failed():
            message = page.Say("error", f"{of_task.task} failed: {of_task.text}", document.id, where, of_task.at_s)
            return done(replace(facts or TaskFacts(""), failed=of_task), message)
        case event.Asked():
            now = done(replace(facts or TaskFacts(""), question=of_task))
            return replace(now, orders=ask_present(model, document, of_task.task))
        case event.Warned():
            text = f"{of_task.task}: {of_task.text}" if of_task.task else of_task.text
            message = page.Say("warning", text, document.id, where if of_task.task else None, of_task.at_s)
            return done(replace(facts or TaskFacts(""), warnings=(facts.warnings if facts else 0) + 1), message)
        case event.Signalled():
            return Done(model, says=(_signal(of_task, document.id),))


def _turned(model: Model, document: Document, subsystem_facts: SubsystemFacts, message: event.TaskState) -> Done:
    """A task's state has changed; what is wanted follows where nobody here has asked for something else."""
    facts = subsystem_facts.tasks.get(message.task)
    if facts is None:  # somebody else's, or one that is dead already
        if message.state == "KILLED" or subsystem_facts.pending:
            return Done(model)
        return Done(model, orders=(look_again(document.id),))
    if message.state == "KILLED":
        if facts.state == "SPAWNING":  # the old one of an exchange
            return Done(model)
        live = subsystem_facts.with_task(message.task, None)
    else:
        live = subsystem_facts.with_task(message.task, _in_state(facts, message.state))
    return Done(model.with_document(settled(replace(document, live=live))))


def _in_state(facts: TaskFacts, state: str) -> TaskFacts:
    return replace(
        facts,
        state=state,
        note="",
        question=facts.question if state == "ASKING" else None,
        present=facts.present if state == "ASKING" else {},
        failed=facts.failed if state == "ERROR" else None,
    )


def _signal(message: event.Signalled, doc: str) -> page.Say:
    where = ShowTask(message.task)
    if message.kind == "FINISH":
        return page.Say("end", f"{message.task} has finished", doc, where, message.at_s)
    text = f"{message.task} signals {message.kind}" + (f": {message.text}" if message.text else "")
    return page.Say("info" if message.kind == "LEGAL" else "warning", text, doc, where, message.at_s)


def _held(model: Model, message: event.Held, at_s: float) -> Done:
    runtime = holders.changed(model.runtime, message, presence.you(model), at_s)
    subsystems = {
        **runtime.subsystems,
        message.subsystem: runtime.holds[message.subsystem].application or message.holder,
    }
    model = replace(model, runtime=msgspec.structs.replace(runtime, subsystems=subsystems))
    document = _home(model, message.subsystem)
    says: tuple[page.Say, ...] = ()
    if message.cause and not message.holder:  # who holds it no more is gone or was silent, and others may want it
        says = (page.Say("warning", f"{message.subsystem}: {message.cause}", document.id if document else ""),)
    if document is None or document.live is None:
        return Done(model, says=says)
    subsystem_facts = replace(document.live, holder=message.holder, offer=None)
    return Done(model.with_document(replace(document, live=subsystem_facts)), says=says)


def _stepped(model: Model, message: event.Stepped) -> Done:
    document = _home(model, message.subsystem)
    if document is None:
        return Done(model)
    line = page.Say("warning", transfer_text.sentence(message), document.id, ShowTask(message.task), message.at_s)
    return Done(model, says=(line,))


def _stopped(model: Model, message: event.Stopped) -> Done:
    text = message.cause if message.is_stopped else ""
    runtime = msgspec.structs.replace(model.runtime, is_stopped=message.is_stopped, stop_text=text)
    text = (
        f"everything is stopped: {message.cause}"
        if message.is_stopped
        else "motion is allowed again; nothing comes on by itself"
    )
    return Done(replace(model, runtime=runtime), says=(page.Say("error" if message.is_stopped else "info", text),))


def _lost(model: Model, message: event.Lost) -> Done:
    units = dict(model.runtime.units)
    if message.name in units:
        units[message.name] = view.UnitView(0.0, is_lost=True)
    runtime = msgspec.structs.replace(model.runtime, units=units)
    return Done(replace(model, runtime=runtime), says=(page.Say("error", f"{message.name} is lost: {message.cause}"),))


def _with_subsystem(model: Model, name: str) -> Model:
    if not name or name in model.runtime.subsystems:
        return model
    subsystems = {**model.runtime.subsystems, name: ""}
    return replace(model, runtime=msgspec.structs.replace(model.runtime, subsystems=subsystems))


def _home(model: Model, subsystem: str) -> Document | None:
    """The document that is connected with a subsystem."""
    documents = model.documents.values()
    return next(
        (
            document
            for document in documents
            if document.live and document.live.state == "live" and document.live.subsystem == subsystem
        ),
        None,
    )
