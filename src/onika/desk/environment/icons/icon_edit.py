"""Changing one placed icon: its description, its values, its picture (requirement D17)."""

from dataclasses import replace

from onika.desk.environment.icons.alteration import altered
from onika.desk.environment.outcome.on_file import on_resting_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state import target_values
from onika.desk.environment.state.icon_words import told_again
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.picture_digits import painted
from onika.desk.environment.state.target_items import items_of
from onika.desk.plan.icon_names import a_kind, named, quoted
from onika.model.application import Icon
from onika.model.flow_path import spots, with_step
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.wire import act
from onika.words.reason import Reason


@on_resting_application
def edit_icon(model: Model, opened: OpenApplication, command: act.EditIcon, _outside: Services) -> Done | No:
    """Change this one icon; those of the dictionary and its other instances stay as they are."""
    spot = spots(opened.application).get(command.step)
    if spot is None:
        return No(Reason.of("desk.icon_gone"))
    icon = spot.step
    if not isinstance(icon, Icon):
        return No(Reason.of("desk.only_icons"))
    changed = _changed(model, icon.onikon, command)
    if isinstance(changed, No):
        return changed
    if changed == icon.onikon:
        return Done(model)
    application = with_step(opened.application, command.step, replace(icon, onikon=changed))
    return altered(model, opened, application, Reason.of("desk.changing_icon", icon=named(icon.onikon)))


def _changed(model: Model, onikon: Onikon, command: act.EditIcon) -> Onikon | No:
    if command.values is not None:
        items = items_of(model, onikon.type)
        if not items and command.values:
            return No(Reason.of("desk.without_values", icon=quoted(onikon), kind=a_kind(onikon.type)))
        typed = target_values.checked(items, command.values)
        if isinstance(typed, dict):
            return No(target_values.refusal_text(typed), fields=typed)
        onikon = replace(onikon, values=typed)
    if command.picture is not None:
        picture = painted(command.picture)
        if not isinstance(picture, Picture):
            return No(Reason.of("desk.picture_unkept", why=picture), fields={"picture": picture})
        onikon = replace(onikon, picture=picture)
    if command.description is not None:
        description = " ".join(command.description.split())
        onikon = replace(onikon, description=description, words=told_again(onikon, description))
    return onikon
