"""Opening a configuration in place of another: what both have keeps cycling untouched (§5.3.4, requirement C15)."""

from collections.abc import Sequence
from dataclasses import replace

from onika.desk.environment.file.configurations import read
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.merge import with_loci
from onika.desk.environment.reconcile.reconciliation import living_units
from onika.desk.environment.reconcile.reconfiguration_diff import Reconfiguration, reconfiguration
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration
from onika.model.planned import task_of
from onika.model.rules.order import Ports
from onika.model.rules.reconfiguration import PlacedTask as Standing, exchange
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import NOTHING, Reason


@on_document
def open_in_place(model: Model, document: Document, command: act.OpenInPlace, outside: Services) -> Done | No:
    """Take over a configuration's tasks as one step; where tasks live, what becomes of them is said first."""
    configuration = read(command.path, outside)
    if isinstance(configuration, No):
        return configuration
    base, opened = configuration.base, configuration.opened
    content = _content(document, opened.value)
    if document.live is not None and document.live.state == "live" and not command.confirmed:
        fate = _fate_of_tasks(model, document, document.live, content)
        if fate:
            meant = Remedy(Reason.of("desk.go_on"), act.OpenInPlace(command.doc, command.path, confirmed=True))
            return No(
                Reason.of("desk.in_place_outcome", name=opened.value.name, document=document.name, outcome=fate),
                (meant,),
            )
    new = replace(document, content=content, opened=opened, base=base.path, has_changed_on_disk=False)
    label = Reason.of("desk.opening_in_place", name=opened.value.name, document=document.name)
    return Done(with_loci(model, new), label, document.id, value=document.id)


def _content(document: Document, configuration: Configuration) -> Content:
    """What both have is wanted as before; newcomers stay OFF by hand (reading 14)."""
    if document.live is None:
        return Content(configuration)
    new, wanted = replace(document.content, configuration=configuration), document.content.wanted
    return replace(new, wanted={name: wanted.get(name, False) and name in new.names for name in new.union})


def _fate_of_tasks(model: Model, document: Document, subsystem_facts: SubsystemFacts, content: Content) -> Reason:
    """What becomes of each task; nothing: nothing happens to any."""
    what = reconfiguration(
        document.content,
        content,
        subsystem_facts,
        model.libraries.within(content.configuration),
        (),
        living_units(model),
    )
    if what.is_nothing and not what.faults:
        return NOTHING
    both = [birth.task.name for birth in what.spawn if birth.task.name in what.kill]
    new = [birth.task.name for birth in what.spawn if birth.task.name not in what.kill]
    gone = [name for name in what.kill if name not in both]
    touched = {*what.kill, *new}
    again = [name for name in _again(model, document, subsystem_facts, what) if name not in touched]
    kept = [
        name for name in content.wanted if name in subsystem_facts.tasks and name not in touched and name not in again
    ]
    parts: tuple[Reason, ...] = (
        _part("desk.tasks_go_on", kept),
        _part("desk.tasks_exchanged", both),
        _part("desk.tasks_initialised", again),
        _part("desk.tasks_killed", gone),
        _part("desk.tasks_spawned", new),
        *what.faults,
    )
    return Reason.of("desk.several_reasons", reasons=tuple(part for part in parts if part))


def _again(model: Model, document: Document, subsystem_facts: SubsystemFacts, what: Reconfiguration) -> tuple[str, ...]:
    """Whose constants come from another task afterwards."""
    tasks = model.libraries_of(document).tasks
    living = [Standing(Ports.of(tasks[name]), tasks[name].module) for name in subsystem_facts.tasks if name in tasks]
    born = [task_of(birth.task) for birth in what.spawn]
    new = [Standing(Ports.of(task), task.module) for task in born]
    return exchange(living, what.kill, new).reinit


def _part(key: str, names: Sequence[str]) -> Reason:
    if names:
        return Reason.of(key, tasks=tuple(names))
    return NOTHING
