"""How the tasks and loci of a document look; what looks as it did is the same object and costs next to nothing."""

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field
from operator import is_
from typing import Literal, TypeVar, cast

from onika.desk.environment.outcome.trouble import error_view
from onika.desk.environment.run_state.question import ask_view
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.configuration import Locus, Placed
from onika.wire.view import AskView, DocumentView, GroupView, LocusView, PlacedView, State

_T = TypeVar("_T")


@dataclass(frozen=True, slots=True)
class MadeDocument:
    """What a document looked like, and what that was made of."""

    document: Document
    libraries: OpenLibraries
    view: DocumentView


def placed_views(document: Document, libraries: OpenLibraries, seen: MadeDocument | None) -> dict[str, PlacedView]:
    """The tasks on the canvas."""
    old = seen.view.tasks if seen else {}
    placed_before = {placed.task: placed for placed in seen.document.content.configuration.placed} if seen else {}
    facts, former = _facts(document), _facts(seen.document) if seen else {}
    tasks = libraries.tasks
    views: dict[str, PlacedView] = {}
    for placed in document.content.configuration.placed:
        name, view = placed.task, old.get(placed.task)
        is_missing, fact = name not in tasks, facts.get(name)
        is_old = (
            view is not None
            and placed_before[name] is placed
            and former.get(name) is fact
            and view.is_missing == is_missing
        )
        views[name] = view if is_old and view else _same(_placed(placed, fact, is_missing, document), view)
    return _same_map(views, old)


def locus_views(document: Document, libraries: OpenLibraries, seen: MadeDocument | None) -> dict[str, LocusView]:
    """The loci on the canvas."""
    old = seen.view.loci if seen else {}
    touched = _touched(document, libraries, seen) if seen else None
    former = {locus.svar: locus for locus in seen.document.content.configuration.loci} if seen else {}
    loci = document.content.configuration.loci
    stale = {
        locus.svar for locus in loci if touched is None or locus.svar in touched or former.get(locus.svar) is not locus
    }
    users = _users(document.content.names, libraries, stale) if stale else {}
    return _same_map(
        {
            svar: _same(_locus(locus, users.get(svar, _NOBODY), document), old.get(svar))
            if svar in stale
            else old[svar]
            for locus in loci
            for svar in (locus.svar,)
        },
        old,
    )


def group_views(document: Document, seen: MadeDocument | None) -> dict[str, GroupView]:
    """The supermodules."""
    old = seen.view.groups if seen else {}
    groups = document.content.configuration.groups
    return _same_map({group.name: _same(GroupView(group.tasks), old.get(group.name)) for group in groups}, old)


@dataclass(slots=True)
class _Users:
    """Who uses a variable."""

    writers: list[str] = field(default_factory=list)
    readers: list[str] = field(default_factory=list)
    is_constant: bool = True


_NOBODY = _Users()
_NO_FACTS: Mapping[str, TaskFacts] = {}
"""Always the same: that nothing of them has changed is seen at once."""


def _facts(document: Document) -> Mapping[str, TaskFacts]:
    live = document.live
    if live is not None and live.state == "live":
        return live.tasks
    return _NO_FACTS


def _same(view: _T, old: _T | None) -> _T:
    return old if old is not None and old == view else view


def _same_map(new: dict[str, _T], old: dict[str, _T]) -> dict[str, _T]:
    """The same map where everything in it is the same."""
    if len(new) == len(old) and all(map(is_, new.values(), old.values())) and list(new) == list(old):
        return old
    return new


def _touched(document: Document, libraries: OpenLibraries, seen: MadeDocument) -> set[str] | None:
    """The variables whose users, or the states of those, have changed; None: all may have."""
    before, now = seen.document.content.names, document.content.names
    changed = set(before) ^ set(now)
    if before != now and [name for name in before if name not in changed] != [
        name for name in now if name not in changed
    ]:
        return None
    old, new = _facts(seen.document), _facts(document)
    if old is not new:
        changed |= {name for name in now if _state(old.get(name)) != _state(new.get(name))}
    if libraries is not seen.libraries:
        changed |= {name for name in now if libraries.box(name) is not seen.libraries.box(name)}
    boxes = [box for name in changed for box in (seen.libraries.box(name), libraries.box(name)) if box is not None]
    return {svar for box in boxes for svar in box.uses}


def _state(facts: TaskFacts | None) -> str:
    return facts.state if facts else ""


def _users(names: Sequence[str], libraries: OpenLibraries, svars: Set[str]) -> dict[str, _Users]:
    users_by_svar: dict[str, _Users] = {}
    for name in names:
        box = libraries.box(name)
        if box is None or svars.isdisjoint(box.uses):
            continue
        for pin in box.pins:
            if pin.svar not in svars:
                continue
            users = users_by_svar.setdefault(pin.svar, _Users([], []))
            side = users.readers if pin.kind.is_input else users.writers
            if not side or side[-1] != name:
                side.append(name)
            if pin.kind.at_cycle:
                users.is_constant = False
    return users_by_svar


def _locus(locus: Locus, users: _Users, document: Document) -> LocusView:
    return LocusView(
        x=locus.x,
        y=locus.y,
        is_shown=locus.show,
        line=_line(users.writers, document),
        is_constant=users.is_constant,
        writers=tuple(users.writers),
        readers=tuple(users.readers),
    )


def _line(writers: Sequence[str], document: Document) -> Literal["live", "idle", "stale"]:
    """Live where a task that is ON writes the variable; stale where its writer failed (look, 2)."""
    facts = _facts(document)
    states = [facts[name].state for name in writers if name in facts]
    if "ON" in states:
        return "live"
    return "stale" if "ERROR" in states else "idle"


def _placed(placed: Placed, facts: TaskFacts | None, is_missing: bool, document: Document) -> PlacedView:
    if facts is None:
        return PlacedView(placed.x, placed.y, placed.in_left, placed.frequency, placed.rtpu, is_missing=is_missing)
    return PlacedView(
        x=placed.x,
        y=placed.y,
        in_left=placed.in_left,
        hz=placed.frequency,
        rtpu=facts.rtpu or placed.rtpu,
        state=cast("State", facts.state),  # the words of a lifecycle, as the runtime tells them
        note=facts.note,
        is_missing=is_missing,
        ask=_ask(facts),
        error=error_view(document, placed.task, facts),
        warnings=facts.warnings,
    )


def _ask(facts: TaskFacts) -> AskView | None:
    if facts.question is None or facts.state != "ASKING":
        return None
    return ask_view(facts.question, facts.present)
