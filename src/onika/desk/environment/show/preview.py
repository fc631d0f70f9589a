"""What is in a file that could be opened, light enough to be drawn in small beside the pointer (requirement G05)."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from onika.desk.environment.file import configurations
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.icon_types import edges_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.application import Application, Icon
from onika.model.configuration import Configuration
from onika.model.rules.box import TaskBox
from onika.model.syntax import Syntax
from onika.store.base_directory import BaseDirectory
from onika.wire import act
from onika.wire.view import PeekIcon, PeekView
from onika.words.reason import Reason

_FLOWS, _ICONS = 2, 12
"""As many are drawn of an application."""

_WIDTH, _HEIGHT = 136, 64
"""Of a task that no open library has."""


def peek(model: Model, command: act.Peek, outside: Services) -> Done | No:
    """What the file says now; the value is a `view.PeekView`."""
    path = Path(command.path)
    if path.suffix == ".appl":
        return _application(model, path)
    reading = configurations.read(command.path, outside)
    if isinstance(reading, No):
        return reading
    return Done(model, value=_drawn(reading.opened.value, model.libraries))


def _application(model: Model, path: Path) -> Done | No:
    if model.syntax is None:
        return No(Reason.of("run.no_syntax_definition"))
    application, faults = BaseDirectory(path.absolute().parent.parent).application(path.stem, model.syntax)
    if application is None:
        return No(Reason.of("run.cannot_be_read", path=str(path), faults=tuple(fault.sentence for fault in faults)))
    return Done(model, value=PeekView(application.name, flows=tuple(_flows(application, model.syntax))))


def _flows(application: Application, syntax: Syntax) -> Iterator[tuple[PeekIcon, ...]]:
    for flow in application.flows[:_FLOWS]:
        icons = [step.onikon for step in flow.steps if isinstance(step, Icon)][:_ICONS]
        yield tuple(PeekIcon("".join(icon.picture.rows), *edges_of(syntax.acting(icon.type))) for icon in icons)


def _drawn(configuration: Configuration, libraries: OpenLibraries) -> PeekView:
    libraries = libraries.within(configuration)
    boxes = {placed.task: libraries.box(placed.task) for placed in configuration.placed}
    places = {
        placed.task: (placed.x, placed.y, box.width if box else _WIDTH, box.height if box else _HEIGHT)
        for placed in configuration.placed
        for box in (boxes[placed.task],)
    }
    return PeekView(configuration.name, places, tuple(dict.fromkeys(_wires(boxes.items()))))


def _wires(boxes: Iterable[tuple[str, TaskBox | None]]) -> Iterator[tuple[str, str]]:
    """Writer and reader of each variable; constants are moved once and would only hide the picture."""
    writers: dict[str, list[str]] = {}
    readers: dict[str, list[str]] = {}
    for name, box in boxes:
        for pin in box.pins if box else ():
            if pin.kind.at_cycle:
                (readers if pin.kind.is_input else writers).setdefault(pin.svar, []).append(name)
    for svar, sources in writers.items():
        for reader in readers.get(svar, ()):
            yield from ((writer, reader) for writer in sources if writer != reader)
