"""Icons of a dictionary are changed and deleted; what is placed stays as it is (requirements D05, D08)."""

from dataclasses import replace

import msgspec

from onika.desk.environment.icons.dictionaries import shown_at_once
from onika.desk.environment.icons.uses import users_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting
from onika.desk.environment.outcome.replacing import kept, present_text
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state import target_values
from onika.desk.environment.state.dictionary import home_of
from onika.desk.environment.state.icon_words import forgotten, told_again
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.picture_digits import painted
from onika.desk.environment.state.restoration import FileText, own_step
from onika.desk.environment.state.target_items import items_of
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import OpenedText
from onika.store.own_copy import saving_place
from onika.store.shipped import is_shipped
from onika.store.user_path import user_path
from onika.wire import act, page
from onika.wire.view import Remedy
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

_MOST = 5
"""Applications that are named."""


def edit_onikon(model: Model, command: act.EditOnikon, outside: Services) -> Done | No:
    """Change what an icon says, its values or its picture; the value is the path of its file."""
    place = _found(model, command.onikon)
    if isinstance(place, No):
        return place
    home, opened = place
    other = user_path(command.base, outside.site.own) if command.base else home.path
    if isinstance(other, Reason):
        return No(other, fields={"base": other})
    target = saving_place(other, outside.site)
    if isinstance(target, Refusal):
        return No(target.reason)
    changed = _changed(model, command, opened.value)
    if isinstance(changed, No):
        return changed
    is_copy = target.path.resolve() != home.path.resolve()
    former = present_text(target.onikon_file(command.onikon))
    saved = target.save_onikon(changed, opened, overwrites=command.overwrites and not is_copy)
    if isinstance(saved, Refusal):
        meant = overwriting(saved, msgspec.structs.replace(command, overwrites=True))
        return No(saved.reason, () if is_copy or command.overwrites else meant)
    gone = forgotten(opened.value, changed.description)
    lost = Reason.of("desk.icon_words_lost", why=gone) if gone else NOTHING
    text = Reason.of("desk.icon_changed", name=command.onikon, path=str(saved.path), lost=lost)
    if is_copy and is_shipped(home.path):
        text = Reason.of("desk.icon_own", name=command.onikon, path=str(saved.path), base=home.path.name, lost=lost)
    now = shown_at_once(model, saved.path, outside.site)
    label, file = Reason.of("run.changing_icon", name=command.onikon), FileText(saved.path, former or None)
    says = (page.Say("success", text), *kept(saved.path, former, outside))
    return Done(now, value=str(saved.path), says=says, own=own_step(label, file, FileText.of(saved.path)))


def remove_onikon(model: Model, command: act.RemoveOnikon, outside: Services) -> Done | No:
    """Delete the file of an icon; it is asked first, with where it is placed."""
    place = _found(model, command.onikon)
    if isinstance(place, No):
        return place
    home, opened = place
    if is_shipped(home.path):
        close = Remedy(Reason.of("desk.close_dictionary", name=home.path.name), act.CloseDictionary(str(home.path)))
        return No(Reason.of("desk.icon_stays", name=command.onikon), (close,))
    if not command.confirmed:
        reason = Reason.of("desk.icon_file_deleted", path=str(opened.path), placed=_placed(model, opened.value))
        return No(reason, (Remedy(Reason.of("desk.delete_it"), act.RemoveOnikon(command.onikon, confirmed=True)),))
    former = present_text(opened.path)
    try:
        opened.path.unlink(missing_ok=True)
    except OSError as error:
        return No(Reason.of("desk.not_deleted", path=str(opened.path), why=system_reason(error)))
    now = shown_at_once(model, opened.path, outside.site)
    says = page.Say("success", Reason.of("desk.icon_deleted", name=command.onikon))
    label = Reason.of("run.deleting_icon", name=command.onikon)
    step = own_step(label, FileText(opened.path, former), FileText(opened.path, None))
    return Done(now, says=(says, *kept(opened.path, former, outside)), own=step)


def _found(model: Model, name: str) -> tuple[BaseDirectory, OpenedText[Onikon]] | No:
    home = home_of(model.dictionaries, name)
    if home is None:
        return No(Reason.of("desk.no_icon", name=name))
    return (home.base, home.onikons[name])


def _changed(model: Model, command: act.EditOnikon, onikon: Onikon) -> Onikon | No:
    """The icon as it is to be, or everything that is wrong with it."""
    wrong: dict[str, Reason] = {}
    if command.values is not None:
        typed = target_values.checked(items_of(model, onikon.type), command.values)
        if isinstance(typed, dict):
            wrong |= typed
        else:
            onikon = replace(onikon, values=typed)
    if command.picture is not None:
        picture = painted(command.picture)
        if not isinstance(picture, Picture):
            wrong["picture"] = picture
        else:
            onikon = replace(onikon, picture=picture)
    if wrong:
        return No(target_values.refusal_text(wrong), fields=wrong)
    if command.description is None:
        return onikon
    description = " ".join(command.description.split())
    return replace(onikon, description=description, words=told_again(onikon, description))


def _placed(model: Model, onikon: Onikon) -> Reason:
    """Where it is placed, in words: there it stays, with its picture and its values."""
    users = users_of(model, onikon)
    if not users:
        return NOTHING
    first, more = users[:_MOST], len(users) - _MOST
    if more > 0:
        return Reason.of("desk.placed_in_more", names=first, count=more)
    return Reason.of("desk.placed_in", names=first)
