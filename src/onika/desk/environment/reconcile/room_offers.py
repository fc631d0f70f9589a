"""What is offered where a change found no gap between cycles: other units, or a moment of hold (law 21)."""

from collections.abc import Iterator
from dataclasses import replace

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import Pending, SubsystemFacts, TightChange
from onika.desk.environment.state.model import Model
from onika.wire import act
from onika.wire.lack_of_room import without_gap
from onika.wire.view import Remedy
from onika.words.reason import Reason

Remedies = tuple[Remedy, ...]


def offered(model: Model, before: Document, pending: Pending, cause: Reason) -> tuple[Model, Remedies]:
    """The buttons beside the message that a change came to nothing, and the model in which they can be pressed.

    `before` is the document as it was before the change was taken back.
    """
    tasks, document = without_gap(cause), model.documents[before.id]
    facts = document.live
    if not tasks or facts is None:
        return model, ()
    if pending.before is None or pending.after is None:
        return model, tuple(Remedy(_hold(facts), act.Renew(document.id, task, holds=True)) for task in tasks)
    if pending.before.edits or document.opened is not before.opened:
        return model, ()  # other files than this one had a part in it
    change = TightChange(pending.before.content, pending.after, document.content.configuration, tasks, pending.turns)
    model = model.with_document(replace(document, live=replace(facts, tight=change)))
    return model, (*_units(model, document.id, tasks), Remedy(_hold(facts), act.FindRoom(document.id)))


def _hold(facts: SubsystemFacts) -> Reason:
    on = tuple(name for name, task in facts.tasks.items() if task.is_moving)
    return Reason.of("desk.offer_hold", tasks=on)


def _units(model: Model, doc: str, tasks: tuple[str, ...]) -> Iterator[Remedy]:
    """Each unit that lives, but where there is no other, one that is started for it."""
    units = model.runtime.units
    facts = model.documents[doc].live
    homes = {task.rtpu for task in facts.tasks.values() if task.is_moving} if facts is not None else set()
    others = [name for name, unit in units.items() if not unit.is_lost and name not in homes]
    for name in others:
        yield Remedy(Reason.of("desk.offer_unit", tasks=tasks, unit=name), act.FindRoom(doc, name))
    if not others:
        free = next(name for number in range(len(units) + 1) if (name := f"rt{number}") not in units)
        yield Remedy(Reason.of("desk.offer_new_unit", tasks=tasks, unit=free), act.FindRoom(doc, free))
