"""Icons of a dictionary and tasks of a library are arranged by hand; the order is kept beside them (D24)."""

from collections.abc import Sequence
from pathlib import Path

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.arrangements import with_arrangements
from onika.desk.environment.state.dictionary import home_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.restoration import FileText, own_step
from onika.model.syntax import same_type
from onika.store.folder_arrangement import FolderArrangement, in_order
from onika.wire import act
from onika.words.fault import Refusal
from onika.words.reason import Reason


def arrange_icon(model: Model, command: act.ArrangeIcon, outside: Services) -> Done | No:
    """Put an icon before another of its type in its dictionary, or behind all of its type."""
    home = home_of(model.dictionaries, command.onikon)
    if home is None:
        return No(Reason.of("desk.no_icon", name=command.onikon))
    kind = home.onikons[command.onikon].value.type
    other = home.onikons.get(command.before)
    if command.before and (other is None or not same_type(other.value.type, kind)):
        return No(Reason.of("desk.arranged_apart", name=command.onikon, other=command.before))
    alike = [name for name, opened in home.onikons.items() if same_type(opened.value.type, kind)]
    folder = home.base.path / "dict"
    return _arranged(model, folder, _moved(model, folder, list(home.onikons), alike, command), command.onikon, outside)


def arrange_task(model: Model, command: act.ArrangeTask, outside: Services) -> Done | No:
    """Put a task before another of its library, or behind all of them."""
    home = model.libraries.homes.get(command.task)
    if home is None:
        return No(Reason.of("desk.no_task", name=command.task))
    if command.before and command.before not in home.tasks:
        return No(Reason.of("desk.arranged_apart", name=command.task, other=command.before))
    folder, names = home.base.path / "module", list(home.tasks)
    return _arranged(model, folder, _moved(model, folder, names, names, command), command.task, outside)


def _moved(
    model: Model,
    folder: Path,
    names: Sequence[str],
    alike: Sequence[str],
    command: act.ArrangeIcon | act.ArrangeTask,
) -> list[str]:
    """All names in their new order; `alike` are those among which one moves, the others stay where they are."""
    moved = command.onikon if isinstance(command, act.ArrangeIcon) else command.task
    order = in_order(names, model.arrangements.get(str(folder), ()))
    group = [name for name in order if name in set(alike) and name != moved]
    at = group.index(command.before) if command.before in group else len(group)
    group.insert(at, moved)
    following = iter(group)
    return [next(following) if name in set(alike) else name for name in order]


def _arranged(model: Model, folder: Path, order: Sequence[str], moved: str, outside: Services) -> Done | No:
    place = FolderArrangement.of(folder, outside.site.own)
    if isinstance(place, Refusal):
        return No(place.reason)
    before = FileText.of(place.file)
    refused = place.saved(order)
    if refused is not None:
        return No(refused.reason)
    now, _ = with_arrangements(model, outside.site)
    after = FileText.of(place.file)
    step = own_step(Reason.of("desk.arranging", name=moved), before, after)
    return Done(now, own=step if before != after else None)
