"""What is held here and what could be: subsystems of documents, and runs of applications that others began (X12)."""

from msgspec import structs

from onika.desk.environment.outcome.on_file import closed
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.holders import flows_with
from onika.desk.environment.reconcile.presence import ask_flows, you
from onika.desk.environment.reconcile.watches import is_going
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.wire import act, request, steer
from onika.wire.view import HoldView, Remedy

_BY_THE_USER = "ended by the user who took it over"


def home(model: Model, subsystem: str) -> Document | None:
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


def named(model: Model, doc: str, subsystem: str, connects: bool = False) -> str | No:
    """The subsystem that an act is about, by its name or by its document; of one that is not connected, empty.

    connects    whether it is refused where the document is not connected
    """
    if subsystem:
        is_there = subsystem in model.runtime.subsystems
        if is_there:
            return subsystem
        return No(f"there is no subsystem {subsystem} any more")
    document = model.documents.get(doc)
    if document is None:
        return closed(DocumentKind.CONFIGURATION)
    if document.live is None or document.live.state != "live":
        connect = Remedy("Connect", act.Connect(document.id))
        if connects:
            return No(f"{document.name} is not connected", (connect,))
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
    own = model.run.homes if model.run is not None else ()
    runs = (name for name, hold in model.runtime.holds.items() if hold.application and name not in own)
    return next((name for name in runs if is_held_here(model, name)), "")


def refused(model: Model, subsystem: str, command: act.Take) -> No | None:
    """Why it is not taken, or not without a word: a run is everything that its flows do."""
    hold = model.runtime.holds.get(subsystem, HoldView())
    if not hold.application or (model.run is not None and subsystem in model.run.homes):
        return None
    if hold.holder and not is_offered_here(model, subsystem):
        return None  # the runtime says why not
    other = model.run.view.name if model.run is not None and is_going(model) else ""
    other = other or model.runtime.holds.get(run_here(model), HoldView()).application
    if other:
        return No(f"{other} runs here already, and one application runs at a time")
    if command.confirmed or is_offered_here(model, subsystem):
        return None
    flows = ", ".join(flows_with(model.runtime.holds, subsystem))
    was = f"{hold.former} began it and is gone" if hold.former else "who began it is gone"
    reason = (
        f"{hold.application} runs in {flows}; {was}. Taken over, it is yours to let go on, or to end. "
        "Taking it over starts nothing and stops nothing"
    )
    return No(reason, (Remedy("Take it over", structs.replace(command, confirmed=True)),))


def steer_taken(model: Model, command: act.SteerTaken, _outside: Services) -> Procedure:
    """Steer a run that was taken over; what moves, or ends it, is asked back first."""
    hold = _held(model, command.subsystem, "steers it")
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
    hold = _held(model, subsystem, "answers it")
    if isinstance(hold, No):
        return hold
    if task not in hold.asks:
        return No(f"{task} asks for nothing any more")
    return simply_done(model, request.Reply(subsystem, task, command.line))


def _held(model: Model, subsystem: str, does: str) -> HoldView | No:
    """A run in a subsystem that is held here; else why it is not for this environment."""
    hold = model.runtime.holds.get(subsystem, HoldView())
    if not hold.application:
        return No(f"no application runs in {subsystem} any more")
    if is_held_here(model, subsystem):
        return hold
    by = hold.holder or "nobody"
    take_it = () if hold.holder else (Remedy("Take it over", act.Take(subsystem=subsystem)),)
    return No(f"{hold.application} is held by {by}; only its holder {does}, everybody can stop", take_it)


def _back(command: act.SteerTaken, application: str) -> No | None:
    """What is asked back first: what it does to the machine."""
    sure = structs.replace(command, confirmed=True)
    match command.wish:
        case "resume":
            reason = f"{application} goes on where it paused, with the icons that its own program has: the robot moves"
            return No(reason, (Remedy("Go on", sure),))
        case "clear":
            reason = f"what failed in {application} is cleared and its action is done again: the robot moves"
            return No(reason, (Remedy("Clear and repeat", sure),))
        case "abort":
            return No(f"{application} ends: its tasks go off, its devices hold", (Remedy("End it", sure),))
    return None


def _wish(command: act.SteerTaken) -> request.Request:
    match command.wish:
        case "pause":
            return steer.Pause()
        case "resume":
            return steer.Resume()
        case "clear":
            return steer.Recover()
    return request.Abort(_BY_THE_USER, command.subsystem)
