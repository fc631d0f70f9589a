"""The greyed set of one document, kept up to date: only what has come or gone is asked about (Equation (2), X01)."""

from collections.abc import Sequence

from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.rules import placement
from onika.wire.view import Objection

_FEW = 20
"""Changed tasks up to which the rest is kept."""

Reasons = tuple[Objection, ...]


class GreyedTasks:
    """Which tasks of the libraries may not be placed in a document, and why; remembers its last answer."""

    def __init__(self, doc: str) -> None:
        self._doc = doc
        self._libraries = OpenLibraries()
        self._names: tuple[str, ...] = ()
        self._shadows: dict[str, dict[str, Reasons]] = {}
        """Of each placed task: whom it keeps out, and why."""
        self._shadowed: dict[str, set[str]] = {}
        """Of each task of the libraries: who keeps it out."""
        self._greyed: dict[str, Reasons] = {}

    def greyed(self, names: tuple[str, ...], libraries: OpenLibraries) -> dict[str, Reasons]:
        """The set for these placed tasks; the same object where nothing has changed."""
        former, self._libraries = self._libraries, libraries
        edited = _edited(former, libraries)
        if not edited and edited is not None and names == self._names:
            return self._greyed
        if edited is None or not _keep_order(self._names, names):
            self._shadows, self._shadowed, self._greyed, edited = {}, {}, {}, set()
        self._names = names
        changed = self._drop((self._shadows.keys() - set(names)) | edited) | self._retold(edited) | self._add(names)
        self._greyed = self._merged(changed)
        return self._greyed

    def _drop(self, gone: set[str]) -> set[str]:
        changed = set[str]()
        for name in gone:
            for other in self._shadows.pop(name, ()):
                self._shadowed[other].discard(name)
                changed.add(other)
        return changed

    def _retold(self, edited: set[str]) -> set[str]:
        """Whom those that stay keep out, where these tasks are others than they were."""
        tasks = self._libraries.tasks
        for other in edited:
            self._shadowed[other] = set()
            for name, shadow in self._shadows.items():
                shadow.pop(other, None)
                if refused := placement.refusals(tasks[other], (tasks[name],)):
                    shadow[other] = reasons(refused, self._doc, tasks[other])
                    self._shadowed[other].add(name)
        return edited

    def _add(self, names: Sequence[str]) -> set[str]:
        changed = set[str]()
        for name in names:
            if name not in self._shadows and name in self._libraries.tasks:
                shadow = self._shadow(name)
                self._shadows[name] = shadow
                for other in shadow:
                    self._shadowed.setdefault(other, set()).add(name)
                    changed.add(other)
        return changed

    def _shadow(self, name: str) -> dict[str, Reasons]:
        kept_out = self._libraries.company.kept_out_by(self._libraries.tasks[name])
        return {task.name: reasons(refused, self._doc, task) for task, refused in kept_out}

    def _merged(self, changed: set[str]) -> dict[str, Reasons]:
        """With the reasons of those that have changed, in the order of the placed tasks."""
        places = {name: place for place, name in enumerate(self._names)}
        greyed = dict(self._greyed)
        for other in changed:
            by = sorted(self._shadowed.get(other, ()), key=places.__getitem__)
            if len(by) == 1:
                greyed[other] = self._shadows[by[0]][other]
            elif by:
                greyed[other] = tuple(reason for name in by for reason in self._shadows[name][other])
            else:
                greyed.pop(other, None)
        return greyed


def _edited(former: OpenLibraries, libraries: OpenLibraries) -> set[str] | None:
    """The tasks that are others than they were, where they are few; None: look at everything anew."""
    if former.tasks is libraries.tasks:
        return set()
    if former.tasks.keys() != libraries.tasks.keys():
        return None
    tasks = {name for name, task in libraries.tasks.items() if former.tasks[name] is not task}
    return tasks if len(tasks) <= _FEW else None


def _keep_order(former: Sequence[str], names: Sequence[str]) -> bool:
    """Whether those that stay stand in the same order."""
    before, after = set(former), set(names)
    return [name for name in former if name in after] == [name for name in names if name in before]
