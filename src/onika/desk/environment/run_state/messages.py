"""What is told of a run in the words of its icons: actions by what they show, without files and lines (E11, X06)."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TypeVar

from onika.desk.environment.run_state.membership import icons
from onika.desk.plan.icon_names import named
from onika.files import appl, rmod
from onika.model.application import Application, Hole, actions, every_flow
from onika.model.syntax import Syntax
from onika.store.program import ApplicationProgram
from onika.wire.plan import Plan, PlannedAction
from onika.words.fault import Place
from onika.words.reason import Argument, Reason

_T = TypeVar("_T")

_Icons = Mapping[str, str]
"""What icons show, by their names."""
_CHOICES = ("host.and_repeats", "host.but_leaves")
"""What a choice does with an action, which it names as its file does."""


@dataclass(frozen=True, slots=True)
class IconWording:
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
    def of(
        cls, place: Place, application: Application, program: ApplicationProgram | None, syntax: Syntax
    ) -> "IconWording":
        """Those of an application that stands in the file `place`, and of what it runs."""
        applications = {place.file: application}
        if program is not None:
            applications |= {
                program.files.get(name, name): application for name, application in program.applications.items()
            }
        by_icon = {
            icon.onikon.name: named(icon.onikon) for each in reversed(applications.values()) for icon in icons(each)
        }
        by_place = {
            (file, line): shown
            for file, application in applications.items()
            for line, shown in _by_line(application, syntax)
        }
        return cls(by_icon, by_place)

    def hearing(self, plan: Plan) -> "IconWording":
        """The same, for what a runtime tells of this plan."""
        every = [action for flow in plan.flows for action in flow.actions]
        names: dict[str, str] = {}
        for action in every:
            names[f"{Place(action.place, action.line)} ({action.name})"] = shown = self.action(action)
            names.setdefault(action.name, shown)
        places = {
            *(planned_action.place for planned_action in every),
            *(task.place for flow in plan.flows for task in flow.tasks),
        }
        files = {
            place: Path(place).name.removesuffix(appl.ENDING).removesuffix(rmod.ENDING) for place in places if place
        }
        return replace(self, actions=names, files=dict(sorted(files.items(), key=lambda pair: -len(pair[0]))))

    def action(self, planned_action: PlannedAction) -> str:
        """An action: what its icon and those of its targets show."""
        here = self.by_place.get((planned_action.place, planned_action.line), {})
        names = (planned_action.job, *(planned_action.target or "").split())
        return " ".join(here.get(name) or self.icon(name) for name in names)

    def icon(self, name: str) -> str:
        """What an icon shows."""
        return self.by_icon.get(name, name)

    def with_icons(self, reason: Reason) -> Reason:
        """A sentence of the runtime, with icons in what fills its gaps."""
        match reason.key:
            case "plain":
                return Reason.plain(self._shown(reason.text))
            case "host.note_at" | "host.note_in":
                file, note = str(reason.args["file"]), self._argument(reason.args["note"])
                return Reason.of("run.what_why", what=self.files.get(file, file), why=note)
            case "engine.action_at":
                return _quoted(self.actions.get(str(reason), str(reason.args["action"])))
            case "engine.name_at" if (place := _own_place(reason)) is not None:
                return self.with_icons(place)
            case key if key in _CHOICES:
                action = str(reason.args["action"])
                return self._with_gaps(reason, action=_quoted(self.actions.get(action, action)))
        return self._with_gaps(reason)

    def _with_gaps(self, reason: Reason, **instead: Argument) -> Reason:
        """The same sentence, with icons in what fills its gaps; one that is not known here stays as it is."""
        args = {name: self._argument(value) for name, value in reason.args.items()} | instead
        if args == reason.args:
            return reason
        try:
            return Reason.of(reason.key, **args)
        except KeyError:
            return reason

    def _argument(self, value: Argument) -> Argument:
        if isinstance(value, tuple):
            return tuple(self._item(item) for item in value)
        return self._item(value)

    def _item(self, value: _T) -> _T | Reason | str:
        match value:
            case Reason():
                return self.with_icons(value)
            case str():
                return self._shown(value)
        return value

    def _shown(self, text: str) -> str:
        """A text with icons in place of files and lines."""
        for file, name in self.files.items():
            if file in text:
                here = rf"(?<!\w){re.escape(file)}"
                text = re.sub(rf"({here}:\d+ \(([^()]*)\))(?:: \2\b)?", self._at_place, text)
                text = name.join(re.split(rf"{here}(?::\d+)?", text))
        return text

    def _at_place(self, match: re.Match[str]) -> str:
        return f"“{self.actions.get(match[1], match[2])}”"


def _quoted(shown: str) -> Reason:
    return Reason.of("run.quoted", text=shown)


def _own_place(reason: Reason) -> Reason | None:
    """Where a thing stands that bears the name of the action there: then the place says it all."""
    place = reason.args["place"]
    if isinstance(place, Reason) and place.args.get("action") == reason.args["name"]:
        return place
    return None


def _by_line(application: Application, syntax: Syntax) -> Iterator[tuple[int, _Icons]]:
    for _, flow in every_flow(application):
        for action in actions(flow, syntax):
            icons_ = (action.icon, *(target for target in action.targets if not isinstance(target, Hole)))
            yield action.icon.line, {icon.onikon.name: named(icon.onikon) for icon in icons_}
