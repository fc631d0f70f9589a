"""A change that found no gap between cycles is done again: on another unit, or in a moment of hold (law 21).

Which of them is the user's choice, by buttons beside the message; what cannot go wrong the runtime does by itself.
"""

from dataclasses import replace

import msgspec

from onika.desk.environment.canvas.task_commands import held_facts
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.merge import with_loci
from onika.desk.environment.reconcile.reconciliation import living_units
from onika.desk.environment.reconcile.rollback import reverted
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TightChange
from onika.desk.environment.state.model import Model
from onika.wire import act, live, request, view
from onika.words.reason import Reason


@on_document
def find_room(model: Model, document: Document, command: act.FindRoom, _outside: Services) -> Done | No | Procedure:
    """Do once more what found no gap, and was taken back."""
    facts = held_facts(model, document)
    if isinstance(facts, No):
        return facts
    tight = facts.tight
    if tight is None or document.content.configuration != tight.rest:
        return No(Reason.of("desk.nothing_without_gap", name=document.name))
    if command.unit:
        return _on_unit(model, document, tight, command.unit)
    return _done(model, document, tight, tight.after, True, Reason.of("desk.in_hold"))


def _on_unit(model: Model, document: Document, tight: TightChange, unit: str) -> Procedure:
    """With its newcomers on a unit, which is started where it does not live."""
    if unit not in living_units(model):
        model, response = yield Ask(model, live.AddUnit(unit))
        if not isinstance(response, request.Done):
            return No(refusal(response))
        units = {**model.runtime.units, unit: view.UnitView()}
        model = replace(model, runtime=msgspec.structs.replace(model.runtime, units=units))
    now = model.documents.get(document.id)
    if now is None or now.live is None or now.live.tight is not tight:
        return No(Reason.of("desk.nothing_without_gap", name=document.name))
    placed = tuple(
        replace(placed, rtpu=unit) if placed.task in tight.tasks else placed
        for placed in tight.after.configuration.placed
    )
    after = replace(tight.after, configuration=replace(tight.after.configuration, placed=placed))
    return _done(model, now, tight, after, False, Reason.of("desk.on_unit", unit=unit))


def _done(model: Model, document: Document, tight: TightChange, after: Content, holds: bool, how: Reason) -> Done:
    """The change once more, as one step; `after` is what it leads to."""
    new = document.having(reverted(document.content, after, tight.before))
    if document.live is not None:
        turns = {**document.live.turns, **tight.turns}
        new = replace(new, live=replace(document.live, tight=None, holds=holds, turns=turns))
    return Done(with_loci(model, new), Reason.of("desk.again", tasks=tight.tasks, how=how), document.id)
