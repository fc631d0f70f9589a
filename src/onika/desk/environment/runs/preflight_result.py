"""What a runtime has found when it looked at an application, kept beside it until it changes (X02)."""

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.outcome.fault_view import Troubles
from onika.desk.environment.runs.retarget_marks import marked
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Looked
from onika.desk.plan.preparation import fault_of
from onika.files import appl, conf, rmod
from onika.wire.plan import Plan
from onika.wire.request import Prepared
from onika.wire.view import FaultView, Remedy, ShowStep
from onika.words.fault import Place

_ENDINGS = "|".join(map(re.escape, (appl.ENDING, conf.ENDING, rmod.ENDING)))
_NOTE = re.compile(rf"(.*?(?:{_ENDINGS}))(?::(\d+))?: (.*)", re.DOTALL)
_RESOLVED = " is re-resolved for "


def looked(model: Model, troubles: Troubles, plan: Plan, prepared: Prepared) -> Model:
    """The model with what was found at the steps where it stands; `plan` has their numbers as lines."""
    opened = model.applications.get(troubles.doc)
    if opened is None:
        return model
    fault_views = (*troubles.told(map(fault_of, prepared.faults), is_of_runtime=True), *_noted(troubles, prepared))
    result = Looked(troubles.application, troubles.redirects, model.runtime.address, fault_views)
    return marked(model.with_application(replace(opened, looked=result)), troubles, plan, prepared)


def worth_noting(prepared: Prepared) -> Iterator[str]:
    """The notes of a run: targets that are re-resolved are counted, for each of them has a mark at its icon."""
    yield from (str(note) for note in prepared.notes if _RESOLVED not in str(note))
    targets = {(resolved.target, resolved.were, resolved.task, resolved.instead_of) for resolved in prepared.resolved}
    for (task, old), count in sorted(Counter(target[2:] for target in targets).items()):
        if count == 1:
            yield f"1 target is re-resolved for {task}, by the pose that it is for {old}"
        else:
            yield f"{count} targets are re-resolved for {task}, by the poses that they are for {old}"


def _noted(troubles: Troubles, prepared: Prepared) -> Iterator[FaultView]:
    """What is only worth knowing; targets that are re-resolved bear a mark of their own."""
    for note in map(str, prepared.notes):
        if _RESOLVED in note:
            continue
        match = _NOTE.fullmatch(note)
        step = troubles.step_of(Place(match[1], int(match[2] or 0))) if match else 0
        text = note
        if match:
            name = Path(match[1]).name
            text = f"{name.removesuffix(rmod.ENDING)}: {match[3]}" if name.endswith(rmod.ENDING) else match[3]
        show = (Remedy("Show it", show=ShowStep(step)),) if step else ()
        yield FaultView(text, "warning", step, show, is_of_runtime=True)
