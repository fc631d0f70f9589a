"""A new module with its `.rmod` and its test is written from a template, and is in its library at once (C31)."""

import msgspec

from onika.desk.environment.canvas import libraries
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.plan.module_template import create_module
from onika.store.base_directory import BaseDirectory
from onika.store.own_copy import saving_place
from onika.store.search_path import with_base
from onika.store.user_path import user_path
from onika.wire import act, page
from onika.wire.view import Remedy
from onika.words.fault import Refusal
from onika.words.reason import Reason, reason_of


def new_module(model: Model, command: act.NewModule, outside: Services) -> Done | No:
    """Write the three files into a base directory of the user's own; the value is the name of the task."""
    base = user_path(command.base, outside.site.own) if command.base else outside.site.own
    if isinstance(base, Reason):
        return No(base, fields={"base": base})
    if base is None:
        return No(Reason.of("desk.no_home_directory"), fields={"base": Reason.of("desk.expected_one")})
    home = saving_place(base, outside.site)
    if isinstance(home, Refusal):
        return No(home.reason, fields={"base": home.reason})
    owner = _owner(model, command.name)
    if owner is not None:
        return _taken(model, command, owner)
    try:
        paths = create_module(command.name, home.path)
    except (ValueError, OSError) as wrong:
        return No(reason_of(wrong), fields={"name": reason_of(wrong)})
    done = libraries.saved_here(model, set(paths[:2]))
    if command.name not in done.model.libraries.tasks:  # a base directory that is not on the search path
        bases = [library.base for library in done.model.libraries.libraries]
        done = libraries.rearranged(done.model, with_base(bases, home, model.search), set(paths[:2]))
    says = page.Say("success", Reason.of("desk.module_made", name=command.name, path=str(paths[0])))
    return Done(done.model, value=command.name, says=(*done.says, says))


def _owner(model: Model, name: str) -> BaseDirectory | None:
    """The open library that has a task or a module of this name."""
    home = model.libraries.homes.get(name)
    if home is not None:
        return home.base
    return next((library.base for library in model.libraries.libraries if name in library.modules), None)


def _taken(model: Model, command: act.NewModule, owner: BaseDirectory) -> No:
    number = 2
    while _owner(model, f"{command.name}_{number}"):
        number += 1
    other = msgspec.structs.replace(command, name=f"{command.name}_{number}")
    reason = Reason.of("desk.module_there", name=command.name, base=owner.path.name)
    call_it = Remedy(Reason.of("desk.call_it", name=other.name), other)
    return No(reason, (call_it,), {"name": Reason.of("desk.one_there", path=str(owner.path))})
