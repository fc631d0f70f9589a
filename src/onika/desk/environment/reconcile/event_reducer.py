"""What a runtime tells becomes facts of documents: states, questions, errors, who holds what (law 22)."""

from dataclasses import replace
from typing import Literal

import msgspec

from onika.desk.environment.outcome.outcome import Done, EditEnd, No
from onika.desk.environment.reconcile import holders, presence, reconciliation, slots, task_reducer
from onika.desk.environment.reconcile.pressed_parts import touched
from onika.desk.environment.reconcile.watches import is_going
from onika.desk.environment.run_state import subsystem_views
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.run import transfer_text
from onika.wire import event, page, view
from onika.wire.view import ShowRecording, ShowTask
from onika.words.reason import NOTHING, Reason

_HolderEvent = event.Held | event.Offered | event.Company | event.Moved | event.SlotEnds | event.ClockSet


def after_event(model: Model, message: event.Event, at_s: float = 0.0) -> Done:
    """The model after a piece of news, and what is worth a line; `at_s` is seconds since 1970."""
    model = _within_runs(_questioned(model, message), message)
    match message:
        case event.TaskState() | event.Failed() | event.Asked() | event.Warned() | event.Signalled():
            return _of_task(model, message)
        case event.Stepped() if message.is_too_far:
            return _stepped(model, message)
        case event.Edited():
            return _edited(model, message)
        case event.LastSecondsKept() if not message.run:
            return _kept(model, message)
        case event.Recording():
            return _recorded(model, message)
        case event.Result() if not is_going(model):  # of a run that is not of this environment
            return Done(model, orders=(presence.ask_what(),))
        case event.Held() | event.Offered() | event.Company() | event.Moved() | event.SlotEnds() | event.ClockSet():
            return _of_holder(model, message, at_s)
        case event.Stopped() | event.Lost() | event.UnitUp() | event.Drive() | event.Outdated() | event.Touched():
            return _of_runtime(model, message)
    return Done(model)


def _edited(model: Model, message: event.Edited) -> Done:
    measuring = model.measuring
    if measuring is not None and (message.subsystem, model.station) == (measuring.name, measuring.station):
        news = ((EditEnd(message.number, model.station), No(message.cause) if message.cause else None),)
        return Done(replace(model, measuring=measuring.ended(message.number, message.cause)), news=news)
    document = _home(model, message.subsystem)
    if document is None:
        return Done(model)
    return reconciliation.edited(model, document.id, message.number, message.cause)


def _kept(model: Model, message: event.LastSecondsKept) -> Done:
    """The last seconds of a subsystem that is held by hand are written: a line leads to them."""
    reason, where = Reason.of("run.last_seconds_kept", path=message.path), ShowRecording(message.path)
    document = _home(model, message.subsystem)
    if document is None or document.live is None:
        return Done(model, says=(page.Say("info", reason, where=where),))
    line = page.Say("info", reason, document.id, where)
    subsystem_facts = replace(document.live, black_box=message.path)
    return Done(model.with_document(replace(document, live=subsystem_facts)), says=(line,))


def _recorded(model: Model, message: event.Recording) -> Done:
    """A configuration is recorded from now on, or no more: a line leads to what was."""
    document = _home(model, message.subsystem)
    if document is not None and document.live is not None:
        facts = replace(document.live, recording=message.path if message.is_on else "")
        model = model.with_document(replace(document, live=facts))
    if message.is_on:
        return Done(model)
    name, doc = (document.name, document.id) if document is not None else (message.subsystem, "")
    reason = Reason.of("run.hand_recorded", name=name, seconds=message.lasted_s, path=message.path)
    where = ShowRecording(message.path)
    if not message.cause:
        return Done(model, says=(page.Say("info", reason, doc, where),))
    reason = Reason.of("run.what_why", what=reason, why=message.cause)
    return Done(model, says=(page.Say("warning", reason, doc, where),))


def _of_holder(model: Model, message: _HolderEvent, at_s: float) -> Done:
    """Who is there, who holds what, for whom it is booked, and where the runs of others are."""
    match message:
        case event.Held():
            return _held(model, message, at_s)
        case event.Offered():
            return presence.offered(model, message, at_s)
        case event.Company():
            return presence.came(model, message)
        case event.Moved():
            return Done(replace(model, runtime=holders.moved(model.runtime, message)))
        case event.SlotEnds() | event.ClockSet():
            return slots.after_slot(model, message, at_s)


def _of_runtime(
    model: Model, message: event.Stopped | event.Lost | event.UnitUp | event.Drive | event.Outdated | event.Touched
) -> Done:
    """What concerns everybody."""
    match message:
        case event.Stopped():
            return _stopped(model, message)
        case event.Lost():
            return _lost(model, message)
        case event.Outdated():
            return _outdated(model, message)
        case event.Touched():
            return Done(touched(model, message))
        case event.UnitUp():
            return _unit_up(model, message)
    if message.state not in ("TRIPPED", "PRESSED") or model.runtime.is_stopped:
        return Done(model)
    return Done(model, says=(page.Say("error", _drive(message)),))


def _drive(message: event.Drive) -> Reason:
    if message.cause:
        return Reason.of("run.drive_is_why", device=message.device, state=message.state, why=message.cause)
    return Reason.of("run.drive_is", device=message.device, state=message.state)


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


def _within_runs(model: Model, message: event.Event) -> Model:
    """What becomes of the tasks of applications, whoever began these."""
    match message:
        case event.TaskState():
            runtime = subsystem_views.turned(model.runtime, message)
        case event.Failed():
            runtime = subsystem_views.failed(model.runtime, message)
        case _:
            return model
    if runtime is model.runtime:
        return model
    return replace(model, runtime=runtime)


def _of_task(model: Model, message: task_reducer.TaskEvent) -> Done:
    """What a task of a connected document tells is a fact of that; a subsystem that nobody knows yet is looked at."""
    document = _home(model, message.subsystem)
    if document is not None:
        return task_reducer.after_event(model, document, message)
    subsystem = message.subsystem
    is_new = bool(subsystem) and subsystem not in model.runtime.subsystems
    is_born = isinstance(message, event.TaskState) and subsystem_views.is_born(model.runtime, message)
    # of the run that goes on here all is asked when its first action begins
    is_asked = (is_new or is_born) and not is_going(model)
    return Done(_with_subsystem(model, subsystem), orders=(presence.ask_what(),) if is_asked else ())


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
        reason = Reason.of("run.what_why", what=message.subsystem, why=message.cause)
        says = (page.Say("warning", reason, document.id if document else ""),)
    if document is None or document.live is None:
        return Done(model, says=says)
    subsystem_facts = replace(document.live, holder=message.holder, offer=None)
    return Done(model.with_document(replace(document, live=subsystem_facts)), says=says)


def _stepped(model: Model, message: event.Stepped) -> Done:
    document = _home(model, message.subsystem)
    if document is None:
        return Done(model)
    line = page.Say("warning", transfer_text.sentence(message), document.id, ShowTask(message.task), is_quiet=True)
    return Done(model, says=(line,))


def _stopped(model: Model, message: event.Stopped) -> Done:
    stop_text = message.cause if message.is_stopped else NOTHING
    runtime = msgspec.structs.replace(model.runtime, is_stopped=message.is_stopped, stop_text=stop_text)
    if message.is_stopped:
        line = page.Say("error", Reason.of("run.all_stopped", cause=message.cause))
    else:
        line = page.Say("info", Reason.of("run.allowed_again"))
    return Done(replace(model, runtime=runtime), says=(line,))


def _lost(model: Model, message: event.Lost) -> Done:
    units = dict(model.runtime.units)
    if message.name in units:
        units[message.name] = view.UnitView(0.0, is_lost=True)
    runtime = msgspec.structs.replace(model.runtime, units=units)
    reason = Reason.of("run.is_lost", name=message.name, cause=message.cause)
    return Done(replace(model, runtime=runtime), says=(page.Say("error", reason),))


def _unit_up(model: Model, message: event.UnitUp) -> Done:
    units = {**model.runtime.units, message.name: view.UnitView(0.0, is_lost=False)}
    runtime = msgspec.structs.replace(model.runtime, units=units)
    says = (page.Say("info", Reason.of("run.unit_up", name=message.name)),)
    return Done(replace(model, runtime=runtime), says=says)


def _outdated(model: Model, message: event.Outdated) -> Done:
    """The files of a world have changed, or are again as they were: told to everybody, and nothing restarts."""
    others = {world: why for world, why in model.runtime.outdated.items() if world != message.world}
    outdated = {**others, message.world: message.text} if message.is_outdated else others
    level: Literal["warning", "info"] = "warning" if message.is_outdated else "info"
    runtime = msgspec.structs.replace(model.runtime, outdated=outdated)
    return Done(replace(model, runtime=runtime), says=(page.Say(level, message.text),))


def _with_subsystem(model: Model, name: str) -> Model:
    if not name or name in model.runtime.subsystems:
        return model
    subsystems = {**model.runtime.subsystems, name: ""}
    return replace(model, runtime=msgspec.structs.replace(model.runtime, subsystems=subsystems))


def _home(model: Model, subsystem: str) -> Document | None:
    """The document that is connected with a subsystem."""
    documents = model.documents_here.values()
    return next(
        (
            document
            for document in documents
            if document.live and document.live.state == "live" and document.live.subsystem == subsystem
        ),
        None,
    )
