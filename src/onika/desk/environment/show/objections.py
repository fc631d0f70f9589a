"""Library tasks that could be placed beside what stands and would not run: type, unit, device, code (R-X01, R-X13)."""

from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.rules import agreement
from onika.wire.view import Objection, Remedy, ShowSource
from onika.words.fault import Refusal
from onika.words.reason import Reason


def objections(document: Document, libraries: OpenLibraries) -> dict[str, tuple[Objection, ...]]:
    """Why tasks would not run, as far as a runtime has read their modules."""
    placed = {name for name in document.content.names if name in libraries.tasks}
    refusals: dict[str, list[Refusal]] = {}
    for svar, users in libraries.contested.items():
        standing = [name for name in users if name in placed]
        for name in users if standing else ():
            refusals.setdefault(name, []).extend(agreement.disagreements(name, svar, users, standing))
    for device, names in libraries.rivals.items():
        standing = [name for name in names if name in placed]
        for name in names if standing else ():
            refusals.setdefault(name, []).extend(agreement.claims(name, device, standing))
    objections_by_task = {
        name: reasons(why, document.id, libraries.tasks[name]) for name, why in refusals.items() if why
    }
    for name, reason in _unread(libraries).items():
        objections_by_task[name] = (reason, *objections_by_task.get(name, ()))
    return {name: why for name, why in objections_by_task.items() if name not in placed}


def _unread(libraries: OpenLibraries) -> dict[str, Objection]:
    """The tasks whose modules cannot be read, where that is known."""
    if not libraries.unread:
        return {}
    return {
        name: Objection(
            Reason.of("run.module_unusable", module=task.module, why=libraries.unread[task.module]),
            (Remedy(Reason.of("run.source"), show=ShowSource(name)),),
        )
        for name, task in libraries.tasks.items()
        if task.module in libraries.unread
    }
