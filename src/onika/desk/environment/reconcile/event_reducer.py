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
from onika.desk.environment.state.live import Live, TaskFacts
from onika.desk.environment.state.model import Model
from onika.desk.run import transfer_text
from onika.wire import event, page, view
from onika.wire.view import ShowTask


def heard(model: Model, told: event.Event, at_s: float = 0.0) -> Done:
    """The model after a piece of news, and what is worth a line; `at_s` is seconds since 1970."""
    model = _questioned(model, told)
    match told:
        case event.TaskState() | event.Failed() | event.Asked() | event.Warned() | event.Signalled():
            return _of_task(model, told)
        case event.Stepped() if told.is_too_far:
            return _stepped(model, told)
        case event.Edited():
            document = _home(model, told.subsystem)
            return reconciliation.edited(model, document.id, told.number, told.cause) if document else Done(model)
        case event.Held():
            return _held(model, told, at_s)
        case event.Offered():
            return presence.offered(model, told, at_s)
        case event.Company():
            return presence.came(model, told)
        case event.Moved():
            return Done(replace(model, runtime=holders.moved(model.runtime, told)))
        case event.Result() if not is_going(model):  # of a run that is not of this environment
            return Done(model, orders=(presence.ask_what(),))
        case event.Stopped():
            return _stopped(model, told)
        case event.Lost():
            return _lost(model, told)
        case event.Drive() if told.state in ("TRIPPED", "PRESSED") and not model.runtime.is_stopped:
            why = f": {told.cause}" if told.cause else ""
            return Done(model, says=(page.Say("error", f"drive {told.device} is {told.state}{why}"),))
    return Done(model)


def _questioned(model: Model, told: event.Event) -> Model:
    """What tasks of applications ask, whoever began these."""
    match told:
        case event.Asked():
            return replace(model, runtime=holders.asked(model.runtime, told))
        case event.TaskState():
            runtime = holders.turned(model.runtime, told)
            return model if runtime is model.runtime else replace(model, runtime=runtime)
    return model


_OfTask = event.TaskState | event.Failed | event.Asked | event.Warned | event.Signalled


def _of_task(model: Model, told: _OfTask) -> Done:
    document = _home(model, told.subsystem)
    if document is None or document.live is None:
        is_new = bool(told.subsystem) and told.subsystem not in model.runtime.subsystems and not is_going(model)
        return Done(_with_subsystem(model, told.subsystem), orders=(presence.ask_what(),) if is_new else ())
    known, facts = document.live, document.live.tasks.get(told.task)
    where = ShowTask(told.task)

    def done(new: TaskFacts, *said: page.Say) -> Done:
        new_live = known.with_task(told.task, new) if facts else known
        return Done(model.with_document(replace(document, live=new_live)), says=said)

    match told:
        case event.TaskState():
            return _turned(model, document, known, told)
        case event.Failed():
            said = page.Say("error", f"{told.task} failed: {told.text}", document.id, where, told.at_s)
            return done(replace(facts or TaskFacts(""), failed=told), said)
        case event.Asked():
            now = done(replace(facts or TaskFacts(""), question=told))
            return replace(now, orders=ask_present(model, document, told.task))
        case event.Warned():
            text = f"{told.task}: {told.text}" if told.task else told.text
            said = page.Say("warning", text, document.id, where if told.task else None, told.at_s)
            return done(replace(facts or TaskFacts(""), warnings=(facts.warnings if facts else 0) + 1), said)
        case event.Signalled():
            return Done(model, says=(_signal(told, document.id),))


def _turned(model: Model, document: Document, known: Live, told: event.TaskState) -> Done:
    """A task's state has changed; what is wanted follows where nobody here has asked for something else."""
    facts = known.tasks.get(told.task)
    if facts is None:  # somebody else's, or one that is dead already
        return (
            Done(model) if told.state == "KILLED" or known.pending else Done(model, orders=(look_again(document.id),))
        )
    if told.state == "KILLED":
        if facts.state == "SPAWNING":  # the old one of an exchange
            return Done(model)
        known = known.with_task(told.task, None)
    else:
        known = known.with_task(told.task, _in_state(facts, told.state))
    return Done(model.with_document(settled(replace(document, live=known))))


def _in_state(facts: TaskFacts, state: str) -> TaskFacts:
    return replace(
        facts,
        state=state,
        note="",
        question=facts.question if state == "ASKING" else None,
        present=facts.present if state == "ASKING" else {},
        failed=facts.failed if state == "ERROR" else None,
    )


def _signal(told: event.Signalled, doc: str) -> page.Say:
    where = ShowTask(told.task)
    if told.kind == "FINISH":
        return page.Say("end", f"{told.task} has finished", doc, where, told.at_s)
    text = f"{told.task} signals {told.kind}" + (f": {told.text}" if told.text else "")
    return page.Say("info" if told.kind == "LEGAL" else "warning", text, doc, where, told.at_s)


def _held(model: Model, told: event.Held, at_s: float) -> Done:
    runtime = holders.changed(model.runtime, told, presence.you(model), at_s)
    subsystems = {**runtime.subsystems, told.subsystem: runtime.holds[told.subsystem].application or told.holder}
    model = replace(model, runtime=msgspec.structs.replace(runtime, subsystems=subsystems))
    document = _home(model, told.subsystem)
    says: tuple[page.Say, ...] = ()
    if told.cause and not told.holder:  # who holds it no more is gone or was silent, and others may want it
        says = (page.Say("warning", f"{told.subsystem}: {told.cause}", document.id if document else ""),)
    if document is None or document.live is None:
        return Done(model, says=says)
    known = replace(document.live, holder=told.holder, offer=None)
    return Done(model.with_document(replace(document, live=known)), says=says)


def _stepped(model: Model, told: event.Stepped) -> Done:
    document = _home(model, told.subsystem)
    if document is None:
        return Done(model)
    said = page.Say("warning", transfer_text.sentence(told), document.id, ShowTask(told.task), told.at_s)
    return Done(model, says=(said,))


def _stopped(model: Model, told: event.Stopped) -> Done:
    text = told.cause if told.is_stopped else ""
    runtime = msgspec.structs.replace(model.runtime, is_stopped=told.is_stopped, stop_text=text)
    said = (
        f"everything is stopped: {told.cause}"
        if told.is_stopped
        else "motion is allowed again; nothing comes on by itself"
    )
    return Done(replace(model, runtime=runtime), says=(page.Say("error" if told.is_stopped else "info", said),))


def _lost(model: Model, told: event.Lost) -> Done:
    units = dict(model.runtime.units)
    if told.name in units:
        units[told.name] = view.UnitView(0.0, is_lost=True)
    runtime = msgspec.structs.replace(model.runtime, units=units)
    return Done(replace(model, runtime=runtime), says=(page.Say("error", f"{told.name} is lost: {told.cause}"),))


def _with_subsystem(model: Model, name: str) -> Model:
    if not name or name in model.runtime.subsystems:
        return model
    subsystems = {**model.runtime.subsystems, name: ""}
    return replace(model, runtime=msgspec.structs.replace(model.runtime, subsystems=subsystems))


def _home(model: Model, subsystem: str) -> Document | None:
    """The document that is connected with a subsystem."""
    documents = model.documents.values()
    return next(
        (one for one in documents if one.live and one.live.state == "live" and one.live.subsystem == subsystem), None
    )
