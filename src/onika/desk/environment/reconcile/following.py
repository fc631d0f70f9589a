"""How the running system follows what is done in the environment, and how that learns of it (law 22)."""

from dataclasses import replace

from onika.desk.environment.outcome.code_faults import looked_through
from onika.desk.environment.outcome.outcome import Done, News, No, Order
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import (
    event_reducer,
    joint_limits,
    putting_back,
    run_reducer as hearing_run,
    watched_runs,
)
from onika.desk.environment.reconcile.breakpoints import changed_breakpoints
from onika.desk.environment.reconcile.descriptions import describe
from onika.desk.environment.reconcile.reconciliation import next_change, noted, pursue_all
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.wire import event, live
from onika.words.reason import Reason


def follow(before: Model, after: Model, outside: Services) -> Done | No:
    """Have the running system follow what differs between two models; a no where it cannot."""
    del outside
    after = looked_through(after)
    marked = changed_breakpoints(before, after)
    if before.documents is after.documents and before.libraries is after.libraries:
        return Done(after, orders=marked)
    hindered = watched_runs.changed(before, after)
    if hindered is not None:
        return hindered
    model, docs = noted(after, before.libraries)
    changed = (
        document.id for document in model.documents.values() if document.id in docs or _is_changed(before, document)
    )
    done = pursue_all(model, tuple(changed))
    if isinstance(done, No):
        return done
    described = _described(before, done.model)
    orders = (*done.orders, *_left(before, after), *described.orders, *marked)
    return replace(done, model=described.model, orders=orders, news=given_up(before, after))


def after_event(model: Model, message: event.Event, outside: Services) -> Done:
    """What a runtime has told."""
    done = event_reducer.after_event(model, message, outside.calendar())
    run = hearing_run.after_event(done.model, message)
    back = putting_back.after_event(run.model, message)
    says, news = (*done.says, *run.says), (*done.news, *run.news)
    orders = (*done.orders, *run.orders, *joint_limits.after_event(run.model, message), *back.orders)
    return Done(back.model, orders=orders, says=says, news=news)


def _is_changed(before: Model, document: Document) -> bool:
    """Whether something may be asked of its subsystem."""
    former, subsystem_facts = before.documents.get(document.id), document.live
    if former is None or subsystem_facts is None or subsystem_facts.base is None:
        return False
    had = former.live.base.edits if former.live is not None and former.live.base is not None else {}
    is_noted = subsystem_facts.base.edits is not had
    return former.content is not document.content or bool(subsystem_facts.turns) or is_noted


def _described(before: Model, after: Model) -> Done:
    """Modules that nobody knows yet are described, where a runtime is there to do it."""
    old, new = before.libraries, after.libraries
    is_same = old.libraries is new.libraries and old.sheets is new.sheets and old.unread is new.unread
    if is_same or after.runtime.state != "linked":
        return Done(after)
    return describe(after)


def given_up(before: Model, after: Model) -> tuple[News, ...]:
    """The news for acts that waited in documents that are no longer open, or no longer connected."""
    homes = {document.id for document in after.documents.values() if document.live and document.live.state == "live"}
    return tuple(
        (next_change(document.id, document.live), No(Reason.of("run.no_longer_connected", name=document.name)))
        for document in before.documents.values()
        if document.live is not None and document.live.is_awaited and document.id not in homes
    )


def _left(before: Model, after: Model) -> tuple[Order, ...]:
    """What was held for documents that are no longer open, or no longer connected, may be held by others."""
    homes = {(document.station, document.live.subsystem) for document in after.documents.values() if document.live}
    return tuple(
        Order(live.Release(document.live.subsystem), station=document.station)
        for document in before.documents.values()
        if document.live
        and document.live.state == "live"
        and document.live.is_held_here
        and (document.station, document.live.subsystem) not in homes
    )
