"""A document joins what runs: the two are merged, and what is placed and does not run is spawned (requirement C12)."""

from collections.abc import Set
from dataclasses import replace

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.reconcile import joint_limits
from onika.desk.environment.reconcile.descriptions import describe
from onika.desk.environment.reconcile.live_facts import settled
from onika.desk.environment.reconcile.merge import Merged, merged, runtime_view
from onika.desk.environment.reconcile.reconciliation import living_units, pursue
from onika.desk.environment.reconcile.task_plan import birth
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import UndoStep
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.wire import page
from onika.wire.runtime_standing import Standing
from onika.wire.view import ShowTask
from onika.words.reason import Reason

_MAIN = "main"


def connected(model: Model, doc: str, standing: Standing, me: str = "", on: Set[str] = frozenset()) -> Done:
    """A document that is to be connected, merged with what there is.

    me      the name by which the runtime knows this environment; empty: it may not change the subsystem
    on      the tasks that come ON where they are spawned; the others stay OFF
    """
    document = model.documents[doc]
    subsystem_facts = document.live or SubsystemFacts(_MAIN)
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    merged_document = merged(model, replace(document, taken=None), replace(subsystem_facts, me=me), standing)
    model = model.with_document(_stepped(document, merged_document, model.next_step))
    done = _spawned(model, merged_document, on)
    described = describe(done.model)
    bounds = joint_limits.connected(described.model, described.model.documents[doc])
    orders, says = (*done.orders, *described.orders, *bounds), (*merged_document.says, *done.says)
    return Done(
        described.model,
        value=Reason.of("desk.connected_with", subsystem=subsystem_facts.subsystem),
        orders=orders,
        says=says,
    )


def _stepped(document: Document, merged_tasks: Merged, number: int) -> Document:
    """With a step, where connecting has changed what stands on the canvas."""
    old, new = document.content, merged_tasks.document.content
    if old.configuration is new.configuration:
        return settled(merged_tasks.document)
    wanted = {name: new.wanted.get(name, False) for name in old.names}
    before = Content(old.configuration, wanted, old.kept)
    step = UndoStep(Reason.of("desk.connecting"), "", before, new, number)
    return settled(replace(merged_tasks.document, history=document.history.done(step)))


def _spawned(model: Model, merged_tasks: Merged, on: Set[str]) -> Done:
    """With what is placed and does not run brought to life; what cannot be is left out, and said."""
    document = model.documents[merged_tasks.document.id]
    units = living_units(model)
    wanted, says = {}, []
    libraries = model.libraries_of(document)
    for name in merged_tasks.spawn:
        placed = document.content.placed(name)
        born = birth(placed, libraries, units) if placed else Reason.of("desk.task_missing", name=name)
        if isinstance(born, Reason):
            says.append(page.Say("warning", Reason.of("desk.left_out", why=born), document.id, ShowTask(name)))
        else:
            wanted[name] = name in on
    if not wanted:
        return Done(model, says=tuple(says))
    content = replace(document.content, wanted={**document.content.wanted, **wanted})
    done = pursue(model, document.having(content))
    if isinstance(done, No):
        return Done(
            model, says=(*says, page.Say("warning", Reason.of("desk.nothing_spawned", why=done.reason), document.id))
        )
    return replace(done, says=(*says, *done.says))
