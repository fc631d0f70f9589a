"""How a subsystem comes to be what its document says: one change at a time, whole or not at all (law 22, X10).

What a document differs in from what the runtime was asked for is asked as one change. What is done meanwhile waits for
its outcome. Where it comes to nothing the document goes back to what it was, and then the rest is asked.
"""

from collections.abc import Iterable
from dataclasses import replace
from functools import partial

from onika.desk.environment.file.undo import edits_between
from onika.desk.environment.outcome.outcome import Done, News, No, Order, SubsystemChange
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.reconcile import merge
from onika.desk.environment.reconcile.live_facts import settled, true_to_facts
from onika.desk.environment.reconcile.reconfiguration_diff import Reconfiguration, reconfiguration, with_facts
from onika.desk.environment.reconcile.rollback import file_before, reverted, without_steps
from onika.desk.environment.reconcile.room_offers import offered
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import Pending, RequestedState, SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.wire import act, live, page, request
from onika.wire.view import Remedy, ShowTask
from onika.words.reason import Reason

_KEPT = 64


def pursue(model: Model, document: Document) -> Done | No:
    """Ask the runtime for what a document differs in from what it was asked for, or wait; a no where it cannot be."""
    outcome = _pursued(model.at(document.station), document)
    if isinstance(outcome, No):
        return outcome
    orders = tuple(order.at(document.station) for order in outcome.orders)
    return replace(outcome, model=outcome.model.at(model.station), orders=orders)


def _pursued(model: Model, document: Document) -> Done | No:
    """The same, with the document's station in focus."""
    subsystem_facts, base = _of(document)
    under_way = next((pending.after for pending in subsystem_facts.pending.values() if pending.after is not None), None)
    content = under_way or base.content
    libraries = model.libraries_of(document)
    what = reconfiguration(content, document.content, subsystem_facts, libraries, base.edits, living_units(model))
    if what.faults:
        return No(Reason.of("run.together", parts=what.faults))
    if what.is_nothing:
        if under_way is None:
            subsystem_facts = replace(
                subsystem_facts, turns={}, base=RequestedState(document.content, document.history)
            )
        return Done(model.with_document(replace(document, live=subsystem_facts)))
    refused = _refused(document, subsystem_facts, what, model)
    if refused:
        return refused
    if under_way is None:
        return _sent(model, document, what)
    return _awaiting(model, document, subsystem_facts)


def pursue_all(model: Model, docs: Iterable[str]) -> Done | No:
    """The same for several documents."""
    done = Done(model)
    for doc in docs:
        outcome = pursue(done.model, done.model.documents[doc])
        if isinstance(outcome, No):
            return outcome
        orders, says = (*done.orders, *outcome.orders), (*done.says, *outcome.says)
        done = Done(outcome.model, orders=orders, says=says, awaits=done.awaits or outcome.awaits)
    return done


def noted(model: Model, former: OpenLibraries, *, but: str = "") -> tuple[Model, tuple[str, ...]]:
    """With what has changed of tasks since former libraries noted in every connected document (but one); in which."""
    changed, docs = edits_between(model.libraries, former), []
    for document in model.documents.values() if changed else ():
        if document.id == but or document.live is None or document.live.base is None:
            continue
        files = {placed.task: placed.file for placed in document.content.configuration.placed}
        base, names = document.live.base, {*document.content.wanted, *document.live.tasks}
        concerned = {files.get(name, name) for name in names}
        edits = {**{name: task for name, task in changed.items() if name in concerned}, **base.edits}
        still = {name: task for name, task in edits.items() if task != model.libraries.edits.get(name)}
        if still == base.edits:
            continue
        live = replace(document.live, base=replace(base, edits=still))
        model = model.with_document(replace(document, live=live))
        docs.append(document.id)
    return model, tuple(docs)


def under_way(document: Document, task: str) -> tuple[Document, int]:
    """With something about a task asked for that changes nothing in the document, and by which count it is known."""
    subsystem_facts, _ = _of(document)
    key = subsystem_facts.requests + 1
    pending = {**subsystem_facts.pending, key: Pending(tasks=frozenset((task,)))}
    return replace(document, live=replace(subsystem_facts, requests=key, pending=pending)), key


def next_change(doc: str, subsystem_facts: SubsystemFacts) -> SubsystemChange:
    """The change of a subsystem that is asked for next."""
    return SubsystemChange(doc, subsystem_facts.changes + 1)


def accepted(
    model: Model, response: request.Response, doc: str, key: int, change: SubsystemChange | None = None
) -> Done:
    """The runtime has accepted what it was asked for, or says all that is wrong with it; acts may wait for `change`."""
    document = model.documents.get(doc)
    subsystem_facts = document.live if document else None
    if document is None or subsystem_facts is None or key not in subsystem_facts.pending:
        return Done(model, news=_news(change, None))
    if not isinstance(response, live.Accepted):
        done = _failed(model, document, key)
        return replace(done, news=(*_news(change, No(refusal(response))), *done.news))
    early = dict(subsystem_facts.early)
    cause = early.pop(response.number, None)
    pending = {**subsystem_facts.pending, key: replace(subsystem_facts.pending[key], number=response.number)}
    model = model.with_document(replace(document, live=replace(subsystem_facts, pending=pending, early=early)))
    done = Done(model) if cause is None else edited(model, doc, response.number, cause)
    return replace(done, news=(*_news(change, None), *done.news))


def edited(model: Model, doc: str, number: int, cause: Reason) -> Done:
    """How something that was accepted has ended: done, or with a cause come to nothing."""
    document = model.documents.get(doc)
    subsystem_facts = document.live if document else None
    if document is None or subsystem_facts is None:
        return Done(model)
    key = next((key for key, pending in subsystem_facts.pending.items() if pending.number == number), None)
    if key is None:
        return _unknown(model, document, subsystem_facts, number, cause)
    if cause:
        done = _failed(model, document, key)
        after, remedies = offered(done.model, document, subsystem_facts.pending[key], cause)
        line = page.Say("error", Reason.of("run.not_changed", cause=cause), doc, remedies=remedies)
        return replace(done, model=after, says=(line, *done.says))
    return _go_on(model, _carried_out(document, key))


def living_units(model: Model) -> tuple[str, ...]:
    """The processing units that live."""
    return tuple(name for name, unit in model.runtime.units.items() if not unit.is_lost)


def _of(document: Document) -> tuple[SubsystemFacts, RequestedState]:
    subsystem_facts = document.live
    if subsystem_facts is None or subsystem_facts.base is None:
        raise ValueError(f"expected a connected document, found {document.name}")
    return subsystem_facts, subsystem_facts.base


def _news(change: SubsystemChange | None, no: No | None) -> tuple[News, ...]:
    return () if change is None else ((change, no),)


def _awaiting(model: Model, document: Document, subsystem_facts: SubsystemFacts) -> Done:
    """What is done while a change is under way goes out with the next one, and is answered with it."""
    document = replace(document, live=replace(subsystem_facts, is_awaited=True))
    return Done(model.with_document(document), awaits=next_change(document.id, subsystem_facts))


def _sent(model: Model, document: Document, what: Reconfiguration) -> Done:
    subsystem_facts, base = _of(document)
    content = document.content
    if what.resting:
        content = replace(content, wanted={**content.wanted, **dict.fromkeys(what.resting, False)})
    key = subsystem_facts.requests + 1
    pending = Pending(base, content, document.history, what.names, turns=subsystem_facts.turns)
    change = next_change(document.id, subsystem_facts)
    message = with_facts(subsystem_facts, what, living_units(model))
    pendings = {**message.pending, key: pending}
    order = what.change(subsystem_facts.subsystem, subsystem_facts.holds)
    subsystem_facts = replace(message, requests=key, changes=change.number, is_awaited=False, holds=False, tight=None)
    subsystem_facts = replace(subsystem_facts, pending=pendings, base=replace(base, edits={}))
    then = partial(accepted, doc=document.id, key=key, change=change)
    says = tuple(_rests(name, document) for name in what.resting)
    document = replace(document, content=content, live=subsystem_facts)
    return Done(model.with_document(document), orders=(Order(order, then),), says=says, awaits=change)


def _carried_out(document: Document, key: int) -> Document:
    """What was asked for is done: from now on the document differs from that alone."""
    subsystem_facts, base = _of(document)
    pending = subsystem_facts.pending[key]
    subsystem_facts = subsystem_facts.without_pending(key)
    content = document.content
    if pending.after is not None:
        after = pending.after
        if not subsystem_facts.pending:
            content = true_to_facts(content, subsystem_facts, after)
            after = true_to_facts(after, subsystem_facts, after)
        base = RequestedState(after, pending.present, base.edits)
    elif not subsystem_facts.pending:
        content = true_to_facts(content, subsystem_facts, base.content)
        base = replace(base, content=true_to_facts(base.content, subsystem_facts, base.content))
    return replace(document, content=content, live=replace(subsystem_facts, base=base))


def _failed(model: Model, document: Document, key: int) -> Done:
    """Without what came to nothing, and with the rest."""
    subsystem_facts, base = _of(document)
    pending = subsystem_facts.pending[key]
    subsystem_facts = subsystem_facts.without_pending(key)
    if pending.before is None or pending.after is None:
        return _go_on(model, settled(replace(document, live=subsystem_facts)))
    before = pending.before
    content = reverted(document.content, before.content, pending.after)
    born = [
        name
        for name in pending.tasks
        if subsystem_facts.state_of(name) == "SPAWNING" and name not in before.content.wanted
    ]
    tasks = {name: task for name, task in subsystem_facts.tasks.items() if name not in born}
    history = without_steps(document.history, before.history, pending.present)
    edits = {name: task for name, task in base.edits.items() if name not in before.edits}
    subsystem_facts = replace(subsystem_facts, tasks=tasks, base=RequestedState(before.content, before.history, edits))
    former = model.libraries
    libraries = former.edited(before.edits) if before.edits else former
    document = file_before(document, before.history, pending.present)
    document = replace(document, content=content, history=history, live=subsystem_facts)
    done = _go_on(merge.with_loci(replace(model, libraries=libraries), document), None, document.id)
    others = pursue_all(*noted(done.model, former, but=document.id))
    if isinstance(others, No):
        return replace(done, says=(*done.says, page.Say("error", others.reason)))
    orders, says = (*done.orders, *others.orders), (*done.says, *others.says)
    return replace(done, model=others.model, orders=orders, says=says)


def _go_on(model: Model, document: Document | None, doc: str = "") -> Done:
    """Look at what there is now, and ask for what was done to the document meanwhile."""
    document = document or model.documents[doc]
    done = pursue(model.with_document(document), document)
    look, (subsystem_facts, base) = merge.look_again(document.id), _of(document)
    if isinstance(done, No):  # what waited cannot be asked any more
        news = ((next_change(document.id, subsystem_facts), No(done.reason)),) if subsystem_facts.is_awaited else ()
        reason = Reason.of("run.not_changed_more", cause=done.reason)
        says = () if news else (page.Say("error", reason, document.id),)
        subsystem_facts = replace(subsystem_facts, turns={}, is_awaited=False)
        document = replace(document, content=base.content, history=base.history, live=subsystem_facts)
        return Done(model.with_document(document), orders=(look,), says=says, news=news)
    done = replace(done, orders=(*done.orders, look))
    document = done.model.documents[document.id]
    subsystem_facts, _ = _of(document)
    if subsystem_facts.is_changing or not subsystem_facts.is_awaited:
        return done
    model = done.model.with_document(replace(document, live=replace(subsystem_facts, is_awaited=False)))
    come_to_nothing = (next_change(document.id, subsystem_facts), None)
    return replace(done, model=model, news=(come_to_nothing,))


def _refused(document: Document, subsystem_facts: SubsystemFacts, what: Reconfiguration, model: Model) -> No | None:
    if subsystem_facts.is_foreign:
        name, holder = subsystem_facts.subsystem, subsystem_facts.holder
        take = Remedy(Reason.of("desk.take_it"), act.Take(document.id))
        return No(Reason.of("desk.held_by", name=name, holder=holder), (take,))
    if model.runtime.is_stopped and what.wakes:
        return No(Reason.of("run.stopped_first"), (Remedy(Reason.of("run.reset"), act.Reset()),))
    return None


def _rests(name: str, document: Document) -> page.Say:
    return page.Say("warning", Reason.of("run.moves_hardware", task=name), document.id, ShowTask(name))


def _unknown(model: Model, document: Document, subsystem_facts: SubsystemFacts, number: int, cause: Reason) -> Done:
    """An outcome that was told before its change was accepted, or one of somebody else's change."""
    if any(pending.number is None for pending in subsystem_facts.pending.values()):
        early = dict(list({**subsystem_facts.early, number: cause}.items())[-_KEPT:])
        return Done(model.with_document(replace(document, live=replace(subsystem_facts, early=early))))
    return Done(model, orders=(merge.look_again(document.id),))
