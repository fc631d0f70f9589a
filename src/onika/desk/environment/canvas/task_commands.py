"""Acts on living tasks: ON, OFF, out of ERROR, initialise anew, answer (requirements C11, C13, C28)."""

from dataclasses import replace

from onika.desk.environment.canvas.placement import absent, several
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, Shown
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.reconcile.reconciliation import accepted, under_way
from onika.desk.environment.reconcile.task_plan import code_of
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import Live
from onika.desk.environment.state.model import Model
from onika.wire import act, live, request
from onika.wire.view import Remedy, ShowLibraries


@on_document
def turn(model: Model, document: Document, asked: act.Turn, _outside: Surroundings) -> Done | No:
    """Turn tasks ON or OFF; one that is placed and does not live is brought to life first."""
    missing = absent(document, asked.tasks) or _unknown(model, document, asked.tasks)
    if missing:
        return missing
    known = _connected(document)
    if isinstance(known, No):
        return known
    broken = [name for name in asked.tasks if known.state_of(name) == "ERROR"]
    if asked.is_on and broken:
        clear = Remedy("Clear, switch on", act.Clear(document.id, broken[0], turns_on=True))
        return No(f"{several(broken)} failed and has to be cleared first", (clear,))
    waiting = [name for name in asked.tasks if asked.is_on and known.state_of(name) == "WAITING"]
    if waiting:
        why = known.tasks[waiting[0]].note or "waits for a constant"
        return No(f"{waiting[0]} {why}: it cannot come on before a task supplies it")
    wanted = {**document.content.wanted, **dict.fromkeys(asked.tasks, asked.is_on)}
    resting = [name for name in asked.tasks if asked.is_on and known.state_of(name) not in ("ON", "ASKING")]
    known = replace(known, turns={**known.turns, **dict.fromkeys(resting, asked.arguments)})
    content = replace(document.content, wanted=wanted)
    turned = replace(document, content=content, live=known)
    label = f"turning {several(asked.tasks)} {'ON' if asked.is_on else 'OFF'}"
    return Done(model.with_document(turned), label, document.id)


@on_document
def toggle(model: Model, document: Document, asked: act.Toggle, outside: Surroundings) -> Done | No | Procedure:
    """ON to OFF and back; a task in ERROR is cleared, and comes on again where that is wanted (C11)."""
    known = _connected(document)
    if isinstance(known, No):
        return known
    state = known.state_of(asked.task)
    if state == "ERROR":
        wanted = document.content.wanted.get(asked.task, False)
        return clear(model, act.Clear(asked.doc, asked.task, turns_on=wanted), outside)
    if state == "KILLING":
        return No(f"{asked.task} is {state}: wait for it")
    is_on = state not in ("ON", "ASKING")
    return turn(model, act.Turn(asked.doc, (asked.task,), is_on), outside)


@on_document
def clear(model: Model, document: Document, asked: act.Clear, _outside: Surroundings) -> No | Procedure:
    """Bring a task out of ERROR, and on again where that is asked; one that cannot be cleared stays in it (C28)."""
    known = _of_living(document, asked.task)
    if isinstance(known, No):
        return known
    if known.state_of(asked.task) != "ERROR":
        return No(f"{asked.task} is {known.state_of(asked.task)}, not in ERROR")
    order = live.Clear(known.subsystem, asked.task)
    if asked.turns_on:  # the change that turns it ON goes out behind
        content = replace(document.content, wanted={**document.content.wanted, asked.task: True})
        document = replace(document, content=content, live=replace(known, turns={**known.turns, asked.task: ""}))
    return _asked(model, document, order, asked.task)


@on_document
def reinit(model: Model, document: Document, asked: act.Reinit, _outside: Surroundings) -> No | Procedure:
    """Initialise a task anew, and all that need its constants."""
    known = _of_living(document, asked.task)
    if isinstance(known, No):
        return known
    return _asked(model, document, live.Reinit(known.subsystem, asked.task), asked.task)


@on_document
def renew(model: Model, document: Document, asked: act.Renew, _outside: Surroundings) -> No | Procedure:
    """Exchange the code of a living task for what its file says now."""
    known = _of_living(document, asked.task)
    if isinstance(known, No):
        return known
    task = model.shelf.tasks.get(asked.task)
    if task is None:
        return No(f"no open library has a task {asked.task}")
    code = code_of(task.module, model.shelf, asked.task)
    if isinstance(code, str):
        return No(f"{asked.task} keeps its code: {code}")
    return _asked(model, document, live.Swap(known.subsystem, asked.task, code), asked.task)


@on_document
def answer(model: Model, document: Document, asked: act.Answer, _outside: Surroundings) -> No | Procedure:
    """Answer what a task asks; it asks again, with the reason, where the answer will not do (C13)."""
    known = _of_living(document, asked.task)
    if isinstance(known, No):
        return known
    if known.state_of(asked.task) != "ASKING":
        return No(f"{asked.task} asks for nothing: it is {known.state_of(asked.task)}")
    return simply_done(model, request.Reply(known.subsystem, asked.task, asked.line))


def _asked(model: Model, document: Document, order: request.Request, task: str) -> Procedure:
    """Something about one task that changes nothing in the document, and whose outcome is told later."""
    document, key = under_way(document, task)
    model, response = yield Ask(model.with_document(document), order)
    done = accepted(model, response, document.id, key)
    if isinstance(response, live.Accepted):
        return done
    yield Shown(done.model, says=done.says, orders=done.orders, news=done.news)
    return No(refusal(response))


def _connected(document: Document) -> Live | No:
    known = document.live
    if known is None or known.state != "live":
        connect = (Remedy("Connect", act.Connect(document.id)),)
        return No(f"{document.name} is not connected: its tasks do not live", connect)
    if known.is_foreign:
        reason = f"{known.subsystem} is held by {known.holder}, who can release it; everybody can stop it"
        return No(reason, (Remedy("Take it", act.Take(document.id)),))
    return known


def _of_living(document: Document, task: str) -> Live | No:
    known = _connected(document)
    if isinstance(known, No) or task in known.tasks:
        return known
    return No(f"{task} does not live")


def _unknown(model: Model, document: Document, tasks: tuple[str, ...]) -> No | None:
    """Tasks that cannot live, because no library knows them."""
    known = document.live.tasks if document.live else {}
    lost = [name for name in tasks if name not in model.shelf.tasks and name not in known]
    if not lost:
        return None
    return No(f"no open library has a task {several(lost)}", (Remedy("Open a library…", show=ShowLibraries()),))
