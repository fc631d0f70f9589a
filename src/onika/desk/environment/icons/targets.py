"""Targets are made: a type, a picture and values, written into a dictionary (requirements D08, D15, B10)."""

from pathlib import Path

import msgspec

from onika.desk.environment.icons.dictionaries import shown_at_once
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting, plain
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state import target_values
from onika.desk.environment.state.dictionary import home_of
from onika.desk.environment.state.icon_types import role_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.picture_digits import painted
from onika.desk.environment.state.target_items import items_of
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.model.syntax import IconType
from onika.store.base_directory import BaseDirectory
from onika.store.site import Site, is_shipped
from onika.wire import act, page
from onika.wire.view import Remedy
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME

_FORM = "expected a name of letters, digits and _ . - that begins with a letter"


def make_target(model: Model, command: act.MakeTarget, outside: Surroundings) -> Done | No:
    """Write a new target, or an icon that does nothing; the value is its name."""
    kind = _kind(model, command.type)
    if isinstance(kind, No):
        return kind
    base = Path(command.base).expanduser().absolute() if command.base else outside.site.own
    if base is None:
        return No(
            "there is no home directory: say in which base directory it is to be", fields={"base": "expected one"}
        )
    wrong = _wrong(model, command)
    if wrong:
        return No(target_values.refusal_text(wrong), fields=wrong)
    home = BaseDirectory(base)
    taken = _taken(model, command, home, outside.site)
    if taken:
        return taken
    typed, picture = target_values.checked(items_of(model, kind.name), command.values), painted(command.picture)
    if not isinstance(typed, tuple) or not isinstance(picture, Picture):
        raise TypeError(f"expected what was looked at before, found {typed!r}")
    onikon = Onikon(command.name, kind.name, " ".join(command.description.split()), typed, picture)
    former = home.open_onikon(command.name, model.syntax)[0] if model.syntax and command.overwrites else None
    saved = home.save_onikon(onikon, former, overwrites=command.overwrites)
    if isinstance(saved, Refusal):
        again = msgspec.structs.replace(command, overwrites=True)
        return No(plain(saved.reason), overwriting(saved, again, "Replace it"))
    text = f"{command.name} is {a_kind(kind.name)} now, in {saved.path}"
    now = shown_at_once(model, saved.path, outside.site)
    return Done(now, value=command.name, says=(page.Say("success", text),))


def _kind(model: Model, name: str) -> IconType | No:
    """The type, where it is one of targets or does nothing."""
    kind = model.syntax.find(name) if model.syntax else None
    if kind is not None and (kind.is_target or kind.is_noop):
        return kind
    names = [
        kind_named(icon_type.name)
        for icon_type in (model.syntax.types if model.syntax else ())
        if icon_type.is_target or icon_type.is_noop
    ]
    expected = f"expected one of {', '.join(names)}"
    if kind is None:
        return No(f"there is no type {kind_named(name)!r}", fields={"type": expected})
    what = "a configuration" if kind.is_job else "an application"
    reason = f"{a_kind(kind.name)} is made of {what}, not drawn by itself"
    return No(reason, fields={"type": expected})


def _wrong(model: Model, command: act.MakeTarget) -> dict[str, str]:
    """What is wrong with name, values and picture, each by its field."""
    wrong: dict[str, str] = {} if TASK_NAME.match(command.name) else {"name": f"{_FORM}, found {command.name!r}"}
    typed = target_values.checked(items_of(model, command.type), command.values)
    wrong |= typed if isinstance(typed, dict) else {}
    picture = painted(command.picture)
    return wrong | ({"picture": picture} if isinstance(picture, str) else {})


def _taken(model: Model, command: act.MakeTarget, home: BaseDirectory, site: Site) -> No | None:
    """Why the name may not be used there, if so (D15)."""
    if is_shipped(home.path) and not command.overwrites:
        return _shipped(command, site.own)
    there = _standing(model, command, home)
    if there is not None:
        return there
    other = home_of(model.dictionaries, command.name)
    if other is None or other.base.path.resolve() == home.path.resolve():
        return None
    places = [directory.path.resolve() for directory in site.directories]
    ours, theirs = home.path.resolve(), other.base.path.resolve()
    is_first = ours in places and (theirs not in places or places.index(ours) < places.index(theirs))
    if is_first and command.overwrites:
        return None
    reason = f"{other.base.path.name} has an icon {command.name}, and names are unique over all dictionaries"
    remedies = (_renamed(model, command), *(_over(command, "Use it in place of that one") if is_first else ()))
    return No(reason, remedies, {"name": f"there is one in {other.base.path}"})


def _standing(model: Model, command: act.MakeTarget, home: BaseDirectory) -> No | None:
    """Why the file that stands there already stays, if so: one of another kind always does."""
    path = home.onikon_file(command.name)
    if model.syntax is None or not path.exists():
        return None
    opened, _ = home.open_onikon(command.name, model.syntax)
    role = role_of(model.syntax.acting(opened.value.type)) if opened else ""
    field = {"name": f"there is one in {home.path}"}
    if role in ("job", "application"):
        what = "configuration" if role == "job" else "application"
        reason = f"{command.name} is the icon of the {what} of that name there"
        return No(reason, (_renamed(model, command),), field)
    if command.overwrites:
        return None
    reason = f"{command.name} is there already" + (
        f", {a_kind(opened.value.type)}" if opened else " and cannot be read"
    )
    return No(reason, (_renamed(model, command), *_over(command)), field)


def _renamed(model: Model, command: act.MakeTarget) -> Remedy:
    number = 2
    while home_of(model.dictionaries, f"{command.name}_{number}"):
        number += 1
    other = msgspec.structs.replace(command, name=f"{command.name}_{number}", overwrites=False)
    return Remedy(f"Call it {other.name}", other)


def _over(command: act.MakeTarget, label: str = "Replace it") -> tuple[Remedy, ...]:
    return () if command.overwrites else (Remedy(label, msgspec.structs.replace(command, overwrites=True)),)


def _shipped(command: act.MakeTarget, own: Path | None) -> No:
    """What comes with Onika is not changed by the way."""
    here = msgspec.structs.replace(command, base="")
    remedies = () if own is None else (Remedy(f"Save it in {own}", here),)
    return No(
        f"{command.name} would be part of Onika itself there", (*remedies, *_over(command, "Change Onika itself"))
    )
