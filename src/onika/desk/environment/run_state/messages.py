"""What is told of a run in the words of its icons: actions by what they show, without files and lines (E11, X06)."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.desk.environment.run_state.membership import icons
from onika.desk.plan.icon_names import named
from onika.files import appl, rmod
from onika.model.application import Application, Hole, actions, every_flow
from onika.model.syntax import Syntax
from onika.store.program import Program
from onika.wire.plan import Plan, PlannedAction
from onika.words.fault import Place

_Icons = Mapping[str, str]
"""What icons show, by their names."""
_CHOSEN = re.compile(r"\b(repeats|leaves) (.+?)(?= with the same target| and goes on)")


@dataclass(frozen=True, slots=True)
class Speech:
    """The words of one run. A runtime knows actions by the names of files; nobody who builds with pictures does."""

    by_icon: _Icons = field(default_factory=dict)
    """An icon that shows something else at another place is there what it shows there."""
    by_place: Mapping[tuple[str, int], _Icons] = field(default_factory=dict)
    """Of each action, by the file and line where it stands."""
    actions: Mapping[str, str] = field(default_factory=dict)
    """What actions are about, by their names, and by file, line and name as a runtime tells them."""
    files: Mapping[str, str] = field(default_factory=dict)
    """What stands for a file, by its path; long paths first, for a short one may be a part of them."""

    @classmethod
    def of(cls, place: Place, application: Application, program: Program | None, syntax: Syntax) -> "Speech":
        """Those of an application that stands in the file `place`, and of what it runs."""
        known = {place.file: application}
        if program is not None:
            known |= {program.files.get(name, name): one for name, one in program.applications.items()}
        by_icon = {one.onikon.name: named(one.onikon) for each in reversed(known.values()) for one in icons(each)}
        by_place = {(file, line): shown for file, one in known.items() for line, shown in _by_line(one, syntax)}
        return cls(by_icon, by_place)

    def hearing(self, plan: Plan) -> "Speech":
        """The same, for what a runtime tells of this plan."""
        every = [one for flow in plan.flows for one in flow.actions]
        told: dict[str, str] = {}
        for one in every:
            told[f"{Place(one.place, one.line)} ({one.name})"] = said = self.action(one)
            told.setdefault(one.name, said)
        places = {*(one.place for one in every), *(task.place for flow in plan.flows for task in flow.tasks)}
        files = {one: Path(one).name.removesuffix(appl.ENDING).removesuffix(rmod.ENDING) for one in places if one}
        return replace(self, actions=told, files=dict(sorted(files.items(), key=lambda one: -len(one[0]))))

    def action(self, one: PlannedAction) -> str:
        """An action: what its icon and those of its targets show."""
        here = self.by_place.get((one.place, one.line), {})
        names = (one.job, *(one.target or "").split())
        return " ".join(here.get(name) or self.icon(name) for name in names)

    def icon(self, name: str) -> str:
        """What an icon shows."""
        return self.by_icon.get(name, name)

    def said(self, text: str) -> str:
        """A text of the runtime."""
        for file, name in self.files.items():
            if file in text:
                here = rf"(?<!\w){re.escape(file)}"
                text = re.sub(rf"({here}:\d+ \(([^()]*)\))(?:: \2\b)?", self._at_place, text)
                text = name.join(re.split(rf"{here}(?::\d+)?", text))
        return text

    def meaning(self, text: str) -> str:
        """What a choice does, in the words of the runtime."""
        return _CHOSEN.sub(lambda found: f"{found[1]} “{self.actions.get(found[2], found[2])}”", text)

    def _at_place(self, found: re.Match[str]) -> str:
        return f"“{self.actions.get(found[1], found[2])}”"


def _by_line(application: Application, syntax: Syntax) -> Iterator[tuple[int, _Icons]]:
    for _, flow in every_flow(application):
        for one in actions(flow, syntax):
            icons_ = (one.icon, *(target for target in one.targets if not isinstance(target, Hole)))
            yield one.icon.line, {icon.onikon.name: named(icon.onikon) for icon in icons_}
