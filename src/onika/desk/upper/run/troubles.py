"""What is wrong with an application, told of its steps and with what could be done about it (E01, X01)."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from onika.desk.preparation import PreparedRun
from onika.desk.upper.flow.belonging import icons
from onika.desk.upper.naming import a, kind_named, listed
from onika.desk.upper.run.wording import EMPTY, said, together
from onika.model.application import Application, Branch, Hole, Icon, Step
from onika.model.flow_path import Spot, flows_by_path, spots
from onika.model.rules.hole import holes
from onika.model.rules.outline import Outline
from onika.model.syntax import Syntax
from onika.store.program import Program
from onika.wire import act
from onika.wire.view import FaultView, Remedy
from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class Troubles:
    """Of an application that was prepared with the numbers of its steps as lines, in the file `place`."""

    doc: str
    application: Application
    syntax: Syntax
    place: Place
    program: Program | None
    _spots: Mapping[int, Spot] = field(default_factory=dict)
    _users: Mapping[str, int] = field(default_factory=dict)

    @classmethod
    def of(cls, doc: str, application: Application, syntax: Syntax, place: Place, prepared: PreparedRun) -> "Troubles":
        """Those of an open application."""
        users: dict[str, int] = {}
        if prepared.program is not None:
            for icon in icons(application):
                _use(icon.onikon.name, icon.number, prepared.program, users)
        return cls(doc, application, syntax, place, prepared.program, spots(application), users)

    def views(self, prepared: PreparedRun) -> Iterator[FaultView]:
        """Everything that was found, faults first."""
        yield from self._holes()
        yield from (self.view(one) for one in together(prepared.faults) if not self._is_hole(one))
        yield from (self.view(one) for one in prepared.notes)

    def view(self, fault: Fault) -> FaultView:
        """One fault or note."""
        step = self.step_of(fault.place)
        remedies = tuple(self._remedies(fault, step))
        return FaultView(said(fault), "warning" if fault.is_note else "fault", step, remedies)

    def step_of(self, place: Place) -> int:
        """The step at which a fault stands, or the first one that uses the file in which it stands; 0: none."""
        if place.file == self.place.file:
            return place.line if place.line in self._spots else 0
        return self._users.get(Path(place.file).name, self._users.get(place.file, 0))

    def user_of(self, name: str) -> int:
        """The first step that uses a configuration, a task or an application; 0: none."""
        return self._users.get(name, 0)

    def _is_hole(self, fault: Fault) -> bool:
        step = self._step(self.step_of(fault.place))
        return isinstance(step, Hole) and fault.place.file == self.place.file and not fault.is_note

    def _holes(self) -> Iterator[FaultView]:
        outline = Outline.of(self.application, self.syntax, self.place.file)
        paths = [path for path, _ in flows_by_path(self.application)]
        path_of = {passage.path: path for passage, path in zip(outline.passages, paths, strict=True)}
        for one in holes(outline, self.syntax):
            steps = one.passage.flow.steps
            before = steps[one.position - 1].number if one.position else 0
            show = Remedy("What fits here", show=f"fits:{path_of[one.passage.path]}:{before}")
            wanted = [Remedy(f"New {kind_named(kind)}…", show=f"target:{kind}") for kind in dict.fromkeys(one.types)]
            missing = a(listed(map(kind_named, one.types))) if one.types else "an action"
            text = f"{missing} is missing here"
            yield FaultView(text, "fault", steps[one.position].number, (show, *wanted))

    def _step(self, number: int) -> Step | None:
        spot = self._spots.get(number)
        return spot.step if spot else None

    def _remedies(self, fault: Fault, number: int) -> Iterator[Remedy]:
        """What is obvious, likeliest first; where it stands comes last."""
        step = self._step(number)
        if isinstance(step, Icon):
            yield from self._of_icon(fault, step)
        if isinstance(step, Branch) and "conditions" in fault.expected:
            yield Remedy("Its conditions…", show=f"step:{number}")
        elif not number and (match := EMPTY.fullmatch(fault.expected)):
            yield Remedy("What fits here", show=f"fits:{match[1]}:0")
        elif number:
            yield Remedy("Show it", show=f"step:{number}")

    def _of_icon(self, fault: Fault, icon: Icon) -> Iterator[Remedy]:
        expected, number = fault.expected, icon.number
        if " loop" in expected and icon.while_tag is not None:
            yield Remedy("Remove the loop", act.RemoveLoop(self.doc, number))
            yield Remedy("Mark it anew…", show=f"loop:{number}")
        elif "tag" in expected and icon.synch_tag is not None:
            yield Remedy("Remove the tag", act.SetSynchTag(self.doc, number))
        elif "as its trigger" in expected or expected == "a type the syntax defines":
            yield Remedy("Take it from the dictionary anew", act.ExchangeIcon(self.doc, number, icon.onikon.name))
        elif expected.startswith("values for") or "within reach" in expected:
            yield Remedy("Its values…", show=f"values:{number}")
        elif expected.endswith(" behind it"):
            spot = self._spots[number]
            yield Remedy("What fits behind it", show=f"fits:{spot.path}:{number}")
        elif expected.startswith(("the configuration ", "the application ", "an action that takes")):
            yield Remedy("Remove it", act.RemoveIcons(self.doc, (number,)))
        elif self.program is not None and icon.onikon.name in self.program.configurations and not fault.is_note:
            yield Remedy("Open its configuration", show=f"configuration:{icon.onikon.name}")


def _use(name: str, number: int, program: Program, users: dict[str, int]) -> None:
    """Notes which step is the first to use which files, and names of what stands in them."""
    waiting = [name]
    while waiting:
        name = waiting.pop()
        if (configuration := program.configurations.get(name)) is not None or name in program.unread:
            names = [f"{name}.conf", f"{name}.appl", name]
            for placed in configuration.placed if configuration else ():
                task = program.tasks.get(placed.task)
                names += [f"{placed.task}.rmod", placed.task, *([f"{task.module}.py"] if task else [])]
            for one in names:
                users.setdefault(one, number)
        elif (application := program.applications.get(name)) is not None and f"{name}.appl" not in users:
            users[f"{name}.appl"] = users[name] = number
            waiting += [icon.onikon.name for icon in icons(application)]
