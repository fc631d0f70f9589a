"""What is held here and what could be: subsystems of documents, and runs of applications that others began (X12)."""

from msgspec import structs

from onika.desk.environment.outcome.on_file import closed
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.holders import flows_with
from onika.desk.environment.reconcile.presence import ask_flows, you
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.wire import act, request, steer
from onika.wire.view import HoldView, Remedy
from onika.words.reason import Reason


def home(model: Model, subsystem: str) -> Document | None:
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


def named(model: Model, doc: str, subsystem: str, connects: bool = False) -> str | No:
    """The subsystem that an act is about, by its name or by its document; of one that is not connected, empty.

    connects    whether it is refused where the document is not connected
    """
    if subsystem:
        is_there = subsystem in model.runtime.subsystems
        if is_there:
            return subsystem
        return No(Reason.of("run.no_subsystem", name=subsystem))
    document = model.documents.get(doc)
    if document is None:
        return closed(DocumentKind.CONFIGURATION)
    if document.live is None or document.live.state != "live":
        connect = Remedy(Reason.of("desk.connect_it"), act.Connect(document.id))
        if connects:
            return No(Reason.of("desk.not_connected", name=document.name), (connect,))
        return ""
    return document.live.subsystem


def called(model: Model, doc: str, subsystem: str) -> str:
    """What it is called where a user speaks of it."""
    if doc in model.documents:
        return model.documents[doc].name
    return subsystem


def holder(model: Model, subsystem: str) -> str:
    """The session that holds it; empty: nobody."""
    document = home(model, subsystem)
    if document is not None and document.live is not None:
        return document.live.holder
    return model.runtime.holds.get(subsystem, HoldView()).holder


def is_held_here(model: Model, subsystem: str) -> bool:
    """Whether this environment may change it."""
    document = home(model, subsystem)
    if document is not None and document.live is not None:
        return document.live.is_held_here
    me = you(model)
    return bool(me) and model.runtime.holds.get(subsystem, HoldView()).holder == me


def is_offered_here(model: Model, subsystem: str) -> bool:
    """Whether its holder would hand it over to this environment."""
    document = home(model, subsystem)
    if document is not None and document.live is not None and document.live.offer is not None:
        return document.live.offer.is_here
    me = you(model)
    return bool(me) and model.runtime.holds.get(subsystem, HoldView()).offered_to == me


def run_here(model: Model) -> str:
    """A flow of the run that another began and that is held here now; empty: there is none."""
    return next((name for name in model.runtime.holds if is_taken_run(model, name)), "")


def is_taken_run(model: Model, subsystem: str) -> bool:
    """Whether the run of another is there, and is held here now."""
    is_own = any(subsystem in run.homes for run in model.runs_here)
    is_run = bool(model.runtime.holds.get(subsystem, HoldView()).application)
    return is_run and not is_own and is_held_here(model, subsystem)


def refused(model: Model, subsystem: str, command: act.Take) -> No | None:
    """Why it is not taken, or not without a word: a run is everything that its flows do."""
    hold = model.runtime.holds.get(subsystem, HoldView())
    is_own = any(subsystem in run.homes for run in model.runs_here)
    is_offered = is_offered_here(model, subsystem)
    if not hold.application or is_own:
        return None
    if hold.holder and not is_offered:
        return None  # the runtime says why not
    other = _application_here(model)
    if other:
        return No(Reason.of("run.runs_here", name=other))
    if command.confirmed or is_offered:
        return None
    take_over = Remedy(Reason.of("run.take_over"), structs.replace(command, confirmed=True))
    return No(_taken_over(model, subsystem, hold), (take_over,))


def _application_here(model: Model) -> str:
    """The application that runs here: one that was begun here, or one that was taken over; empty: none does."""
    if model.going:
        return model.going[0].view.name
    return model.runtime.holds.get(run_here(model), HoldView()).application


def _taken_over(model: Model, subsystem: str, hold: HoldView) -> Reason:
    """What taking over the run of another means."""
    flows = flows_with(model.runtime.holds, subsystem)
    was = Reason.of("run.former_gone", name=hold.former) if hold.former else Reason.of("run.former_gone_unnamed")
    return Reason.of("run.take_over_what", name=hold.application, flows=flows, was=was)


def steer_taken(model: Model, command: act.SteerTaken, _outside: Services) -> Procedure:
    """Steer a run that was taken over; what moves, or ends it, is asked back first."""
    hold = _held(model, command.subsystem, is_answered=False)
    if isinstance(hold, No):
        return hold
    meant = _back(command, hold.application)
    if meant is not None and not command.confirmed:
        return meant
    model, response = yield Ask(model, _wish(command))
    if isinstance(response, request.Done):
        return Done(model, orders=(ask_flows(),))
    return No(refusal(response))


def answer(model: Model, command: act.Answer, _outside: Services) -> No | Procedure:
    """Answer what a task of a run that was taken over asks, named as `SUBSYSTEM/TASK`; it goes on with the answer."""
    subsystem, _, task = command.task.rpartition("/")
    hold = _held(model, subsystem, is_answered=True)
    if isinstance(hold, No):
        return hold
    if task not in hold.asks:
        return No(Reason.of("run.no_answer_wanted", task=task))
    return simply_done(model, request.Reply(subsystem, task, command.line))


def _held(model: Model, subsystem: str, *, is_answered: bool) -> HoldView | No:
    """A run in a subsystem that is held here; else why it is not for this environment to answer it, or to steer it."""
    hold = model.runtime.holds.get(subsystem, HoldView())
    if not hold.application:
        return No(Reason.of("run.no_application_in", subsystem=subsystem))
    if is_held_here(model, subsystem):
        return hold
    holder = hold.holder or Reason.of("run.nobody")
    take_it = () if hold.holder else (Remedy(Reason.of("run.take_over"), act.Take(subsystem=subsystem)),)
    if is_answered:
        return No(Reason.of("run.held_only_answers", name=hold.application, holder=holder), take_it)
    return No(Reason.of("run.held_only_steers", name=hold.application, holder=holder), take_it)


def _back(command: act.SteerTaken, application: str) -> No | None:
    """What is asked back first: what it does to the machine."""
    sure = structs.replace(command, confirmed=True)
    match command.wish:
        case "resume":
            go_on = Remedy(Reason.of("desk.go_on"), sure)
            return No(Reason.of("run.goes_on_paused", name=application), (go_on,))
        case "clear":
            repeat = Remedy(Reason.of("run.clear_and_repeat"), sure)
            return No(Reason.of("run.cleared_repeats", name=application), (repeat,))
        case "abort":
            end = Remedy(Reason.of("run.end_it"), sure)
            return No(Reason.of("run.ends_devices_hold", name=application), (end,))
    return None


def _wish(command: act.SteerTaken) -> request.Request:
    match command.wish:
        case "pause":
            return steer.Pause()
        case "resume":
            return steer.Resume()
        case "clear":
            return steer.Recover()
    return request.Abort(Reason.of("run.ended_by_taker"), command.subsystem)
