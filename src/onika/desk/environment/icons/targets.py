"""Targets are made: a type, a picture and values, written into a dictionary (requirements D08, D15, B10)."""

import msgspec

from onika.desk.environment.icons.dictionaries import shown_at_once
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state import target_values
from onika.desk.environment.state.arrangements import with_arrangements
from onika.desk.environment.state.dictionary import find, home_of
from onika.desk.environment.state.icon_types import role_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.picture_digits import painted
from onika.desk.environment.state.restoration import FileText, own_step
from onika.desk.environment.state.target_items import items_of
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.model.syntax import IconType, same_type
from onika.store.base_directory import BaseDirectory
from onika.store.folder_arrangement import FolderArrangement, in_order
from onika.store.own_copy import saving_place
from onika.store.site import Site
from onika.store.user_path import user_path
from onika.wire import act, page
from onika.wire.view import Remedy
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason


def make_target(model: Model, command: act.MakeTarget, outside: Services) -> Done | No:
    """Write a new target, or an icon that does nothing; the value is its name."""
    kind = _kind(model, command.type)
    if isinstance(kind, No):
        return kind
    base = user_path(command.base, outside.site.own) if command.base else outside.site.own
    if isinstance(base, Reason):
        return No(base, fields={"base": base})
    if base is None:
        return No(Reason.of("desk.no_home_directory"), fields={"base": Reason.of("desk.expected_one")})
    wrong = _wrong(model, command)
    if wrong:
        return No(target_values.refusal_text(wrong), fields=wrong)
    home = saving_place(base, outside.site)
    if isinstance(home, Refusal):
        return No(home.reason, fields={"base": home.reason})
    taken = _taken(model, command, home, outside.site)
    if taken:
        return taken
    onikon = _made(model, command, kind)
    former = home.open_onikon(command.name, model.syntax)[0] if model.syntax and command.overwrites else None
    before = FileText.of(home.onikon_file(command.name))
    saved = home.save_onikon(onikon, former, overwrites=command.overwrites)
    if isinstance(saved, Refusal):
        again = msgspec.structs.replace(command, overwrites=True)
        return No(saved.reason, overwriting(saved, again, Reason.of("desk.replace_it")))
    text = Reason.of("desk.target_made", name=command.name, kind=a_kind(kind.name), path=str(saved.path))
    now = shown_at_once(model, saved.path, outside.site)
    if find(model.dictionaries, command.name) is None:
        now = _placed_last(now, home, command.name, outside.site)
    step = own_step(Reason.of("run.making_target", name=command.name), before, FileText.of(saved.path))
    return Done(now, value=command.name, says=(page.Say("success", text),), own=step)


def _made(model: Model, command: act.MakeTarget, kind: IconType) -> Onikon:
    """The icon, where nothing is wrong with its values and its picture; else raises TypeError."""
    typed, picture = target_values.checked(items_of(model, kind.name), command.values), painted(command.picture)
    if not isinstance(typed, tuple) or not isinstance(picture, Picture):
        raise TypeError(f"expected what was looked at before, found {typed!r}")
    arm = command.arm if kind.is_target else ""
    return Onikon(command.name, kind.name, " ".join(command.description.split()), typed, picture, arm=arm)


def _placed_last(model: Model, home: BaseDirectory, name: str, site: Site) -> Model:
    """With a new icon behind those of its type, which keep their places; where no order can be kept, by its name."""
    dictionary = home_of(model.dictionaries, name)
    if dictionary is None or dictionary.base != home:
        return model
    folder, kind = home.path / "dict", dictionary.onikons[name].value.type
    order = in_order(list(dictionary.onikons), model.arrangements.get(str(folder), ()))
    alike = [other for other in order if same_type(dictionary.onikons[other].value.type, kind)]
    place = FolderArrangement.of(folder, site.own)
    if alike[-1] == name or isinstance(place, Refusal):
        return model
    others = [other for other in order if other != name]
    return model if place.saved([*others, name]) is not None else with_arrangements(model, site)[0]


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
    expected = Reason.of("desk.one_of", names=tuple(names))
    if kind is None:
        return No(Reason.of("desk.no_type", kind=kind_named(name)), fields={"type": expected})
    what = Reason.of("desk.a_configuration") if kind.is_job else Reason.of("desk.an_application")
    reason = Reason.of("desk.made_of", kind=a_kind(kind.name), what=what)
    return No(reason, fields={"type": expected})


def _wrong(model: Model, command: act.MakeTarget) -> dict[str, Reason]:
    """What is wrong with name, values and picture, each by its field."""
    names = {"name": command.name} | ({"arm": command.arm} if command.arm else {})
    wrong = {
        field: Reason.of("desk.icon_name", name=name) for field, name in names.items() if not TASK_NAME.match(name)
    }
    typed = target_values.checked(items_of(model, command.type), command.values)
    wrong |= typed if isinstance(typed, dict) else {}
    picture = painted(command.picture)
    return wrong | ({} if isinstance(picture, Picture) else {"picture": picture})


def _taken(model: Model, command: act.MakeTarget, home: BaseDirectory, site: Site) -> No | None:
    """Why the name may not be used there, if so (D15)."""
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
    reason = Reason.of("desk.name_taken", base=other.base.path.name, name=command.name)
    remedies = (_renamed(model, command), *(_over(command, Reason.of("desk.use_in_place")) if is_first else ()))
    return No(reason, remedies, {"name": Reason.of("desk.one_there", path=str(other.base.path))})


def _standing(model: Model, command: act.MakeTarget, home: BaseDirectory) -> No | None:
    """Why the file that stands there already stays, if so: one of another kind always does."""
    path = home.onikon_file(command.name)
    if model.syntax is None or not path.exists():
        return None
    opened, _ = home.open_onikon(command.name, model.syntax)
    role = role_of(model.syntax.acting(opened.value.type)) if opened else ""
    field = {"name": Reason.of("desk.one_there", path=str(home.path))}
    if role in ("job", "application"):
        of_job, of_other = "desk.icon_of_configuration", "desk.icon_of_application"
        reason = Reason.of(of_job if role == "job" else of_other, name=command.name)
        return No(reason, (_renamed(model, command),), field)
    if command.overwrites:
        return None
    if opened:
        reason = Reason.of("desk.icon_there", name=command.name, kind=a_kind(opened.value.type))
    else:
        reason = Reason.of("desk.icon_unreadable_there", name=command.name)
    return No(reason, (_renamed(model, command), *_over(command)), field)


def _renamed(model: Model, command: act.MakeTarget) -> Remedy:
    number = 2
    while home_of(model.dictionaries, f"{command.name}_{number}"):
        number += 1
    other = msgspec.structs.replace(command, name=f"{command.name}_{number}", overwrites=False)
    return Remedy(Reason.of("desk.call_it", name=other.name), other)


def _over(command: act.MakeTarget, label: Reason | None = None) -> tuple[Remedy, ...]:
    again = msgspec.structs.replace(command, overwrites=True)
    if command.overwrites:
        return ()
    return (Remedy(label or Reason.of("desk.replace_it"), again),)
