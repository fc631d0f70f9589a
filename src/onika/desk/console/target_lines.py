"""The console command `target`: a target is made of what a variable holds now (requirements C30, D08, D15)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from onika.desk.console.inspection import refused
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.site_library import SiteLibrary
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.desk.plan.target_inputs import unit_of_variable
from onika.desk.plan.target_refusal import unfit
from onika.desk.run.readings_text import types_of
from onika.model.initials import drawn
from onika.model.onikon import Onikon
from onika.model.rules.target_fit import TargetFit, VariableValue, fits_in
from onika.model.syntax import DataItem, IconType, Syntax
from onika.store.base_directory import BaseDirectory
from onika.store.own_copy import saving_place
from onika.store.site import Site
from onika.store.user_path import user_path
from onika.wire import live
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of
from onika.words.value import Value

Words = tuple[str, ...]
Kinds = list[tuple[IconType, dict[str, str]]]
"""Types of targets, each with the units of its data by name."""

_IN = "in"


@dataclass(frozen=True, slots=True)
class _Wish:
    """What a line asks for: `given` are the words of data that are typed, by the data's names."""

    name: str
    variable: str
    type: str = ""
    given: Mapping[str, str] = field(default_factory=dict)
    folder: str = ""


def target(session: ConsoleSession, words: Words) -> Faults:
    """Write a new target whose values are those that a variable holds now."""
    wish = _wish(words)
    library = SiteLibrary(session.site, session.place)
    syntax, faults = session.site.syntax()
    if syntax is None:
        return faults
    variable = _present(session, library, wish.variable)
    if not isinstance(variable, VariableValue):
        return variable
    onikon = _made(wish, variable, syntax, library.target_kinds(syntax))
    if isinstance(onikon, Reason):
        return session.no(onikon)
    saved = _saved(onikon, wish.folder, session.site)
    if isinstance(saved, Reason):
        return session.no(saved)
    kind = a_kind(onikon.type)
    session.say(Reason.of("desk.target_made", name=onikon.name, kind=kind, path=str(saved)))
    return ()


def _wish(words: Words) -> _Wish:
    name, variable, *rest = words
    folder = ""
    if len(rest) > 1 and rest[-2] == _IN:
        *rest, _, folder = rest
    given = dict(word.split("=", 1) for word in rest if "=" in word)
    return _Wish(name, variable, " ".join(word for word in rest if "=" not in word), given, folder)


def _present(session: ConsoleSession, library: SiteLibrary, word: str) -> VariableValue | Faults:
    """What the variable holds now."""
    subsystem, name = session.address(word)
    answer = session.ask(live.Read(subsystem, (name,)))
    if not isinstance(answer, live.Values):
        return refused(session, Reason.of("console.variable_of", name=name, subsystem=subsystem), answer)
    if name not in answer.values:
        return session.no(Reason.of("console.no_variable", subsystem=subsystem, name=name))
    unit = unit_of_variable(name, library.ports)
    return VariableValue(name, types_of(answer)[name], answer.values[name], unit)


def _made(wish: _Wish, variable: VariableValue, syntax: Syntax, every: Kinds) -> Onikon | Reason:
    """The target, else why there can be none."""
    if not TASK_NAME.match(wish.name):
        return Reason.of("desk.icon_name", name=wish.name)
    kinds = _with(wish.given, _named(wish.type, syntax, every))
    fits = [fit for kind, units in kinds for fit in fits_in(kind, variable, units) if fit.item not in wish.given]
    types = tuple(dict.fromkeys(fit.type for fit in fits))
    if not kinds:
        return Reason.of("console.no_target_type", type=wish.type, kinds=_names([kind.name for kind, _ in every]))
    if not types:
        return unfit(variable, kinds)
    if len(types) > 1:
        return Reason.of("console.which_target", name=variable.name, kinds=_names(types))
    kind = next(kind for kind, _ in kinds if kind.name == types[0])
    values = _values(kind, fits[0], wish.given)
    if isinstance(values, Reason):
        return values
    return Onikon(wish.name, kind.name, "", values, drawn(wish.name))


def _named(type_: str, syntax: Syntax, every: Kinds) -> Kinds:
    """The types that are meant: all where none is named; `joint` is as good as `Joint object`."""
    if not type_:
        return every
    meant = {kind.name for name in (type_, f"{type_} object") if (kind := syntax.find(name))}
    return [(kind, units) for kind, units in every if kind.name in meant]


def _with(given: Mapping[str, str], kinds: Kinds) -> Kinds:
    """Those that have the data that are typed; all where none has them, which is told."""
    return [pair for pair in kinds if set(given) <= {item.name for item in pair[0].items}] or kinds


def _names(types: Sequence[str]) -> tuple[Reason, ...]:
    return tuple(map(kind_named, types))


def _values(kind: IconType, fit: TargetFit, given: Mapping[str, str]) -> tuple[tuple[Value, ...], ...] | Reason:
    """The values of all data: those of the variable in their place, the others as they were typed."""
    others = [item for item in kind.items if item.name != fit.item]
    names = tuple(item.name for item in others)
    unknown = tuple(name for name in given if name not in names)
    if unknown:
        return Reason.of("console.no_datum", kind=kind_named(kind.name), names=unknown)
    lacking = tuple(name for name in names if name not in given)
    if lacking:
        return Reason.of("console.datum_lacks", kind=kind_named(kind.name), names=lacking, first=lacking[0])
    try:
        typed = {item.name: _typed(item, given[item.name]) for item in others}
    except ValueError as wrong:
        return reason_of(wrong)
    return tuple(fit.values if item.name == fit.item else typed[item.name] for item in kind.items)


def _typed(item: DataItem, text: str) -> tuple[Value, ...]:
    """The values of a datum, parted by commas where there are several; raises ValueError with what is wrong."""
    words = [text] if item.count == 1 else text.split(",")
    if not item.takes(len(words)):
        raise ValueError(Reason.of("rules.fit_count", item=item.name, count=item.count, given=text))
    return tuple(item.type.parse(word) for word in words)


def _saved(onikon: Onikon, folder: str, site: Site) -> Path | Reason:
    """Where the new file stands, else why there is none: a name stands for one icon on the search path."""
    base = user_path(folder, site.own) if folder else site.own
    if isinstance(base, Reason):
        return base
    if base is None:
        return Reason.of("desk.no_home_directory")
    home = saving_place(base, site)
    if isinstance(home, Refusal):
        return home.reason
    taken = next((other for other in (home, *site.directories) if _has(other, onikon.name)), None)
    if taken is not None:
        return Reason.of("desk.one_there", path=str(taken.onikon_file(onikon.name)))
    saved = home.save_onikon(onikon)
    return saved.reason if isinstance(saved, Refusal) else saved.path


def _has(base: BaseDirectory, name: str) -> bool:
    return base.onikon_file(name).exists()
