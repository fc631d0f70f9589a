"""Acts on living tasks: ON, OFF, out of ERROR, initialise anew, answer (requirements C11, C13, C28)."""

from collections.abc import Iterator
from dataclasses import replace

from onika.desk.environment.canvas.placement import absent, several
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.staleness import says_otherwise
from onika.desk.environment.reconcile.reconciliation import accepted, under_way
from onika.desk.environment.reconcile.task_plan import code_of, is_hardware
from onika.desk.environment.reconcile.watched_runs import is_on, refusal as watched_by
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.model.planned import task_of
from onika.model.task import Task
from onika.wire import act, live, request
from onika.wire.view import Remedy, ShowLibraries
from onika.words.reason import Reason


@on_document
def turn(model: Model, document: Document, command: act.Turn, _outside: Services) -> Done | No:
    """Turn tasks ON or OFF; one that is placed and does not live is brought to life first."""
    missing = absent(document, command.tasks) or _unknown(model, document, command.tasks)
    if missing:
        return missing
    subsystem_facts = held_facts(model, document)
    if isinstance(subsystem_facts, No):
        return subsystem_facts
    broken = [name for name in command.tasks if subsystem_facts.state_of(name) == "ERROR"]
    if command.is_on and broken:
        clear = Remedy(Reason.of("desk.clear_and_on"), act.Clear(document.id, broken[0], turns_on=True))
        return No(Reason.of("desk.failed_first", names=several(broken)), (clear,))
    waiting = [name for name in command.tasks if command.is_on and subsystem_facts.state_of(name) == "WAITING"]
    if waiting:
        why = subsystem_facts.tasks[waiting[0]].note or Reason.of("desk.waits_for_constant")
        return No(Reason.of("desk.on_before_supplied", name=waiting[0], why=why))
    wanted = {**document.content.wanted, **dict.fromkeys(command.tasks, command.is_on)}
    resting = [
        name for name in command.tasks if command.is_on and subsystem_facts.state_of(name) not in ("ON", "ASKING")
    ]
    subsystem_facts = replace(
        subsystem_facts, turns={**subsystem_facts.turns, **dict.fromkeys(resting, command.arguments)}
    )
    content = replace(document.content, wanted=wanted)
    turned = replace(document, content=content, live=subsystem_facts)
    key_on, key_off = "desk.turning_on", "desk.turning_off"
    label = Reason.of(key_on if command.is_on else key_off, name=several(command.tasks))
    return Done(model.with_document(turned), label, document.id)


@on_document
def toggle(model: Model, document: Document, command: act.Toggle, outside: Services) -> Done | No | Procedure:
    """ON to OFF and back; a task in ERROR is cleared, and comes on again where that is wanted (C11).

    One that moves a device is only cleared: that it moves again is said by a press of its own.
    """
    subsystem_facts = held_facts(model, document)
    if isinstance(subsystem_facts, No):
        return subsystem_facts
    state = subsystem_facts.state_of(command.task)
    if state == "ERROR":
        comes_on = document.content.wanted.get(command.task, False) and not _moves(model, document, command.task)
        return clear(model, act.Clear(command.doc, command.task, turns_on=comes_on), outside)
    if state == "KILLING":
        return No(Reason.of("desk.state_wait", task=command.task, state=state))
    is_on = state not in ("ON", "ASKING")
    return turn(model, act.Turn(command.doc, (command.task,), is_on), outside)


@on_document
def clear(model: Model, document: Document, command: act.Clear, _outside: Services) -> No | Procedure:
    """Bring a task out of ERROR, and on again where that is asked; one that cannot be cleared stays in it (C28)."""
    of_living = _of_living(model, document, command.task)
    if isinstance(of_living, No):
        return of_living
    if of_living.state_of(command.task) != "ERROR":
        return No(Reason.of("desk.not_in_error", task=command.task, state=of_living.state_of(command.task)))
    order = live.Clear(of_living.subsystem, command.task)
    if command.turns_on:  # the change that turns it ON goes out behind
        content = replace(document.content, wanted={**document.content.wanted, command.task: True})
        document = replace(
            document, content=content, live=replace(of_living, turns={**of_living.turns, command.task: ""})
        )
    return _asked(model, document, order, command.task)


@on_document
def reinit(model: Model, document: Document, command: act.Reinit, _outside: Services) -> No | Procedure:
    """Initialise a task anew, and all that need its constants."""
    of_living = _of_living(model, document, command.task)
    if isinstance(of_living, No):
        return of_living
    return _asked(model, document, live.Reinit(of_living.subsystem, command.task), command.task)


@on_document
def renew(model: Model, document: Document, command: act.Renew, _outside: Services) -> Done | No | Procedure:
    """Exchange a living task, or its code alone, for what its files say now."""
    of_living = _of_living(model, document, command.task)
    if isinstance(of_living, No):
        return of_living
    libraries = model.libraries_of(document)
    task = libraries.tasks.get(command.task)
    if task is None:
        return No(Reason.of("desk.no_task", name=command.task))
    code = code_of(task.module, libraries, command.task)
    if isinstance(code, Reason):
        return No(Reason.of("desk.keeps_code", task=command.task, why=code))
    planned = of_living.tasks[command.task].planned
    if planned is not None and says_otherwise(planned, task):
        return _exchanged(model, document, of_living, task_of(planned))
    return _asked(model, document, live.Swap(of_living.subsystem, command.task, code, command.holds), command.task)


@on_document
def answer(model: Model, document: Document, command: act.Answer, _outside: Services) -> No | Procedure:
    """Answer what a task asks; it asks again, with the reason, where the answer will not do (C13)."""
    of_living = _of_living(model, document, command.task)
    if isinstance(of_living, No):
        return of_living
    if of_living.state_of(command.task) != "ASKING":
        return No(Reason.of("desk.asks_nothing", task=command.task, state=of_living.state_of(command.task)))
    return simply_done(model, request.Reply(of_living.subsystem, command.task, command.line))


def held_facts(model: Model, document: Document) -> SubsystemFacts | No:
    """What is known of the subsystem of a document, where its tasks live and may be changed from here."""
    if document.watched is not None and is_on(model, document.watched):
        return watched_by(model, document, document.watched)
    subsystem_facts = document.live
    if subsystem_facts is None or subsystem_facts.state != "live":
        connect = (Remedy(Reason.of("desk.connect_it"), act.Connect(document.id)),)
        return No(Reason.of("desk.tasks_not_living", name=document.name), connect)
    if subsystem_facts.is_foreign:
        name, holder = subsystem_facts.subsystem, subsystem_facts.holder
        reason = Reason.of("desk.held_by", name=name, holder=holder)
        return No(reason, (Remedy(Reason.of("desk.take_it"), act.Take(document.id)),))
    return subsystem_facts


def _exchanged(model: Model, document: Document, of_living: SubsystemFacts, former: Task) -> Done | No:
    """With a task noted as changed, so that the one of its file takes its place with the next change."""
    placed = document.content.placed(former.name)
    if placed is None or of_living.base is None:
        return No(Reason.of("desk.not_on_canvas", name=former.name))
    base = replace(of_living.base, edits={**of_living.base.edits, placed.file: former})
    label = Reason.of("desk.taking_over_file", task=former.name)
    return Done(model.with_document(replace(document, live=replace(of_living, base=base))), label, document.id)


def _asked(model: Model, document: Document, order: request.Request, task: str) -> Procedure:
    """Something about one task that changes nothing in the document, and whose outcome is told later."""
    document, key = under_way(document, task)
    model, response = yield Ask(model.with_document(document), order)
    done = accepted(model, response, document.id, key)
    if isinstance(response, live.Accepted):
        return done
    yield InterimModel(done.model, says=done.says, orders=done.orders, news=done.news)
    why = refusal(response)
    return No(why, tuple(_writers_first(document, why)))


def _writers_first(document: Document, why: Reason) -> Iterator[Remedy]:
    """Where a device waits for tasks that feed it and have failed: these are cleared before it."""
    writers = why.args["writers"] if why.key == "host.clear_writers_first" else ()
    for writer in writers if isinstance(writers, tuple) else ():
        yield Remedy(Reason.of("desk.clear_writer", task=writer), act.Clear(document.id, str(writer)))


def _moves(model: Model, document: Document, name: str) -> bool:
    """Whether a task moves a device; one of which nothing is known counts as if it did."""
    libraries = model.libraries_of(document)
    placed = document.content.placed(name)
    task = libraries.tasks.get(placed.file if placed else name)
    return task is None or is_hardware(task, libraries)


def _of_living(model: Model, document: Document, task: str) -> SubsystemFacts | No:
    subsystem_facts = held_facts(model, document)
    if isinstance(subsystem_facts, No) or task in subsystem_facts.tasks:
        return subsystem_facts
    return No(Reason.of("desk.not_living", task=task))


def _unknown(model: Model, document: Document, tasks: tuple[str, ...]) -> No | None:
    """Tasks that cannot live, because no library knows them."""
    facts_by_task = document.live.tasks if document.live else {}
    library_tasks = model.libraries_of(document).tasks
    lost = [name for name in tasks if name not in library_tasks and name not in facts_by_task]
    if not lost:
        return None
    return No(
        Reason.of("desk.no_task", name=several(lost)), (Remedy(Reason.of("desk.open_library"), show=ShowLibraries()),)
    )
