"""An environment to try acts on applications: a dictionary of plain icons of every kind, and short words for flows.

A flow is said by the names of its icons, `_` for a hole, `<>` for a branch: `move there _ grip`.
"""

from collections.abc import Iterable
from pathlib import Path

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.icons.alteration import flow_at
from onika.desk.environment.initial_model import opened
from onika.model.application import Application, Branch, Hole, Icon
from onika.model.initials import drawn
from onika.model.onikon import Onikon
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import ApplicationView, StepView

JOINTS = ((0.1, 0.2, 0.3, 0.4, 0.5, 0.6), (1.5,))
POSE = ((0.1, 0.2, 0.3, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0), (2.0,))


def onikon(name: str, kind: str, description: str = "", values: tuple[tuple[float, ...], ...] = ()) -> Onikon:
    """An icon with its initials for a picture."""
    return Onikon(name, kind, description, values, drawn(name))


ONIKONS = (
    onikon("grip", "Complete job", "close the hand"),
    onikon("open", "Complete job", "open the hand"),
    onikon("move", "Joint job", "move the joints"),
    onikon("slide", "Cartesian job", "move on a straight line"),
    onikon("there", "Joint object", "above triangle", JOINTS),
    onikon("here", "Joint object", "beside the box", JOINTS),
    onikon("spot", "Cartesian object", "over the hole", POSE),
    onikon("wait", "Complete NOP", "do nothing"),
    onikon("visit", "Joint application", "visit a place"),
    onikon("whole", "Complete application", "build it"),
    Onikon("arc", "Joint job", "move by way of", (), drawn("arc"), ("Joint object",)),
)


class AppFixture(EnvironmentFixture):
    """An environment with these icons in its dictionary, which may have others before it."""

    def __init__(
        self, folder: Path, onikons: Iterable[Onikon] = ONIKONS, before: tuple[BaseDirectory, ...] = ()
    ) -> None:
        base = BaseDirectory(folder)
        for onikon in onikons:
            base.save_onikon(onikon)
        model, _ = opened(Site((*before, base), shipped() / "prefs", folder / "home"), None, {})
        super().__init__(folder, (), model)

    def begun(self, *icons: str, flows: int = 1, is_parallel: bool = False) -> str:
        """A new application with these icons in its first flow; its id."""
        doc: str = self.do(act.NewApplication(flows, is_parallel))
        self.add(doc, *icons)
        return doc

    def add(self, doc: str, *icons: str, flow: str = "0", after: int = 0) -> list[int]:
        """Insert icons one behind the other; their numbers."""
        numbers = []
        for name in icons:
            after = self.do(act.InsertIcon(doc, name, flow, after))
            numbers.append(after)
        return numbers

    def application(self, doc: str) -> Application:
        """What is open under this id."""
        return self.environment.model.applications[doc].application

    def flow(self, doc: str, path: str = "0") -> str:
        """A flow in words."""
        flow = flow_at(self.application(doc), path)
        if flow is None:
            raise AssertionError(f"expected a flow {path}, found none")
        return " ".join(
            step.onikon.name if isinstance(step, Icon) else "_" if isinstance(step, Hole) else "<>"
            for step in flow.steps
        )

    def number(self, doc: str, name: str, path: str = "0") -> int:
        """The number of the first icon of this name in a flow; `_` is a hole, `<>` a branch."""
        flow = flow_at(self.application(doc), path)
        for step in flow.steps if flow else ():
            kinds = {"_": Hole, "<>": Branch}
            if isinstance(step, kinds[name]) if name in kinds else isinstance(step, Icon) and step.onikon.name == name:
                return step.number
        raise AssertionError(f"expected {name} in flow {path}, found {self.flow(doc, path)}")

    def view(self, doc: str) -> ApplicationView:
        """How the page sees it."""
        return self.environment.tree.applications[doc]

    def step(self, doc: str, name: str, path: str = "0") -> StepView:
        """How the page sees a step."""
        return self.view(doc).steps[str(self.number(doc, name, path))]
