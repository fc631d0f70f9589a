"""The job that a configuration would make, with everything worth knowing before it is made (C16, C29, D15)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from onika.desk.environment.outcome.fault_text import simple
from onika.desk.environment.outcome.trouble import said
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.icon_types import role_of
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.files import conf
from onika.model.onikon import Onikon
from onika.model.rules import conflict, warning
from onika.model.rules.iconify import ActionType, job_type
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import OpenedText
from onika.store.site import Site
from onika.words.fault import Place
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class Draft:
    """A job that could be made.

    edges     the numbers of its left and right edge in the syntax
    warnings  what will not work, and what is lost
    notes     what is odd and never forbidden (C08)
    former    the icon that it has already
    source    the file that it is made of
    taken     why another icon would be lost where this one is saved; empty: none would
    """

    name: str
    home: BaseDirectory
    kind: ActionType
    edges: tuple[int, int]
    warnings: tuple[Reason, ...]
    notes: tuple[Reason, ...]
    source: Path
    former: OpenedText[Onikon] | None = None
    taken: Reason = NOTHING

    @property
    def says(self) -> Reason:
        """What it is then, in words."""
        if self.source.suffix == conf.ENDING:
            return Reason.of("desk.a_job")
        return Reason.of("desk.icon_for_applications")

    @property
    def path(self) -> Path:
        """Where its icon stands or would stand."""
        return self.home.onikon_file(self.name)


def drafted(document: Document, site: Site) -> Draft | tuple[Reason, ...]:
    """The job of a document that has a file; else all reasons why it makes none. Tasks count as their files say."""
    if document.base is None:
        raise ValueError(f"expected a document with a file, found {document.id}")
    syntax, faults = site.syntax()
    if syntax is None:
        return tuple(fault.sentence for fault in faults)
    home = BaseDirectory(document.base)
    tasks = _tasks(document, site.at(home.path))
    kind = job_type(document.content.configuration, tasks, syntax)
    if not isinstance(kind, ActionType):
        return tuple(simple(refusal.reason) for refusal in kind)
    former, taken = former_of(document.name, home, syntax, "job")
    acting = syntax.acting(kind.type)
    standing = [tasks[name] for name in document.content.names]
    warnings = (
        *((taken,) if taken else ()),
        *(
            Reason.of("desk.may_not_stand_together", later=later.name, earlier=earlier.name)
            for later, earlier, _ in conflict.conflicts(standing)
        ),
        *of_type(kind, syntax, former),
        *namesakes(document.name, home, site),
    )
    return Draft(
        name=document.name,
        home=home,
        kind=kind,
        edges=(acting.left_edge, acting.right_edge) if acting else (0, 0),
        warnings=warnings,
        notes=_notes(document, standing),
        source=home.configuration_file(document.name),
        former=former,
        taken=taken,
    )


def _tasks(document: Document, site: Site) -> dict[str, Task]:
    configuration = document.content.configuration
    records = {placed.file: site.task(placed.file)[0] for placed in configuration.placed}
    return configuration.tasks({name: record.task for name, record in records.items() if record})


def former_of(name: str, home: BaseDirectory, syntax: Syntax, role: str) -> tuple[OpenedText[Onikon] | None, Reason]:
    """The icon that a job or application has; and why what stands in its place is none of its own (reading 34)."""
    path = home.onikon_file(name)
    if not path.exists():
        return None, NOTHING
    former, faults = home.open_onikon(name, syntax)
    if former is None:
        return None, Reason.of(
            "desk.icon_lost_unread", path=str(path), reasons=tuple(fault.sentence for fault in faults)
        )
    if role_of(syntax.acting(former.value.type)) != role:
        return None, Reason.of("desk.icon_lost", path=str(path), kind=a_kind(former.value.type))
    return former, NOTHING


def of_type(kind: ActionType, syntax: Syntax, former: OpenedText[Onikon] | None) -> Iterator[Reason]:
    """A type that is not defined (D16), and an icon that says another one (reading 36)."""
    if syntax.find(kind.type) is None:
        yield Reason.of("desk.type_undefined", kind=kind_named(kind.type), role=_role(kind, syntax))
    if former and (former.value.type, former.value.more_targets) != (kind.type, kind.more_targets):
        yield Reason.of("desk.icon_says", kind=kind_named(former.value.type))


def namesakes(name: str, home: BaseDirectory, site: Site) -> Iterator[Reason]:
    """Other icons of that name: of two the first on the search path counts (D15)."""
    paths = [base.path.resolve() for base in site.directories]
    own = paths.index(home.path.resolve()) if home.path.resolve() in paths else None
    if own is None:
        yield Reason.of("desk.not_on_path", path=str(home.path))
    for place, base in enumerate(site.directories):
        if place != own and base.onikon_file(name).exists():
            path, is_ours = str(base.path), own is not None and own < place
            ours = Reason.of("desk.this_icon_counts", path=path, name=name)
            yield ours if is_ours else Reason.of("desk.that_icon_counts", path=path, name=name)


def _role(kind: ActionType, syntax: Syntax) -> str:
    return role_of(syntax.acting(kind.type))


def _notes(document: Document, tasks: Sequence[Task]) -> tuple[Reason, ...]:
    place = Place(document.name)
    return tuple(
        said(further_trigger)
        for further_trigger in (*warning.hanging(tasks, place), *warning.further_triggers(tasks, place))
    )
