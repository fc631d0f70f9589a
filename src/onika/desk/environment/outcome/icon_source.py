"""What the icon of an action stands for: its file, and whether that is still what the icon says (reading 36)."""

from collections.abc import Iterable
from pathlib import Path

from onika.desk.environment.outcome.fault_text import simple
from onika.desk.environment.state.dictionary import Dictionary
from onika.desk.environment.state.icon_types import role_of
from onika.desk.environment.state.model import Model
from onika.desk.plan.icon_names import a_kind
from onika.files import appl, conf
from onika.model.configuration import Configuration
from onika.model.onikon import Onikon
from onika.model.rules.iconify import ActionType, job_type
from onika.model.rules.union import devices
from onika.model.syntax import Syntax, same_type
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason

_ENDINGS = {"job": conf.ENDING, "application": appl.ENDING}


class Sources:
    """The files behind icons, as the model knows them; nothing is read."""

    def __init__(self, model: Model, syntax: Syntax) -> None:
        self._syntax = syntax
        self._sources = model.sources
        self._tasks = {name: record.task for name, record in model.libraries.records.items()}
        ranks = {path: place for place, path in enumerate(model.search)}
        homes = {path: Path(path).parent.parent for path in model.sources}
        self._first: dict[str, str] = {}
        for path in sorted(homes, key=lambda path: ranks.get(homes[path], len(ranks))):
            self._first.setdefault(Path(path).name, path)

    def path_of(self, onikon: Onikon, dictionary: Dictionary) -> str:
        """The file behind an icon: beside its dictionary, else the first on the search path (reading 35); or empty."""
        role = role_of(self._syntax.acting(onikon.type))
        if role not in _ENDINGS:
            return ""
        name = onikon.name + _ENDINGS[role]
        beside = str(dictionary.base.path / name.rpartition(".")[2] / name)
        if beside in self._sources:
            return beside
        return self._first.get(name, "")

    def trouble(self, onikon: Onikon, path: str) -> Reason:
        """Why an action cannot run; empty: nothing is in the way, or it is none."""
        role = role_of(self._syntax.acting(onikon.type))
        if role not in _ENDINGS:
            return NOTHING
        is_job = role == "job"
        if not path:
            key = "run.no_configuration" if is_job else "run.no_application"
            return Reason.of(key, name=onikon.name)
        kind = self._kind(path)
        if kind is None:
            key = "run.configuration_at_fault" if is_job else "run.application_at_fault"
            return Reason.of(key, path=path)
        if not isinstance(kind, ActionType):
            return Reason.of("run.together", parts=tuple(simple(refusal.reason) for refusal in kind))
        if _is_alike((onikon.type, *onikon.more_targets), (kind.type, *kind.more_targets)):
            return NOTHING
        key = "run.its_configuration_makes" if is_job else "run.its_application_makes"
        return Reason.of(key, kind=_with_targets(kind), given=_with_targets(onikon))

    def hardware_of(self, job: str) -> tuple[str, ...]:
        """Those of the first configuration of this name on the search path."""
        return self.hardware(self._first.get(job + conf.ENDING, ""))

    def hardware(self, path: str) -> tuple[str, ...]:
        """The tasks with a device of the configuration in this file; none of another file."""
        source = self._sources.get(path)
        if not isinstance(source, Configuration):
            return ()
        return tuple(name for name, task in source.tasks(self._tasks).items() if any(devices(task)))

    def _kind(self, path: str) -> ActionType | tuple[Refusal, ...] | None:
        source = self._sources.get(path)
        if isinstance(source, Configuration):
            return job_type(source, source.tasks(self._tasks), self._syntax)
        return source


def _is_alike(one: Iterable[str], other: Iterable[str]) -> bool:
    first, second = tuple(one), tuple(other)
    return len(first) == len(second) and all(map(same_type, first, second))


def _with_targets(kind: ActionType | Onikon) -> Reason:
    """A type in words, with the targets that it takes beyond the one that it names."""
    if kind.more_targets:
        return Reason.of("run.kind_with", kind=a_kind(kind.type), more=tuple(map(a_kind, kind.more_targets)))
    return a_kind(kind.type)
