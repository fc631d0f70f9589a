"""Acts on applications as the diary knows them: which icon, and the icon it was put behind (requirement H01, §E.2)."""

from collections.abc import Iterable, Mapping

from onika.desk.environment.state.model import Model
from onika.model.application import AppFlow, Branch, Icon, Step
from onika.model.flow_path import flows_by_path
from onika.wire import act

Things = tuple[str, str, str, str]
"""Object, its id, associated object, its id."""


class ApplicationNames:
    """What applications are called, and their steps by their ids, `a1/17`; who is gone keeps its name."""

    def __init__(self) -> None:
        self.names: dict[str, str] = {}
        self._read: dict[tuple[str, str], AppFlow] = {}
        """The flows as they were looked at last: thousands of names are not read again with every act."""

    def look(self, model: Model, docs: Iterable[str]) -> None:
        """Take in what there is, of steps those of the applications among `docs`."""
        self.names |= {application.id: application.name for application in model.applications.values()}
        for doc in docs:
            if opened := model.applications.get(doc):
                self.names[f"{doc}/0"] = "Start"
                for path, flow in flows_by_path(opened.application):
                    if self._read.get((doc, path)) is not flow:
                        self.names |= {f"{doc}/{step.number}": _name_of(step) for step in flow.steps}
                        self._read[doc, path] = flow


def _name_of(step: Step) -> str:
    if isinstance(step, Icon):
        return step.onikon.name
    return "branch" if isinstance(step, Branch) else "hole"


def things(command: act.AnyAct, value: object, names: Mapping[str, str]) -> Things | None:
    """What an act on an application was about; None: its document alone, or it is none."""
    match command:
        case act.NewApplication():
            doc = str(value or "")
            return names.get(doc, ""), doc, "", ""
        case act.InsertIcon() | act.InsertBranch():
            return *_inserted(command, value), *_of(command.doc, command.after, names)
        case act.ExchangeIcon():
            return command.onikon, _id(command.doc, command.step), names.get(command.doc, ""), command.doc
        case act.MoveIcons():
            return *_each(command.doc, command.steps, names), *_of(command.doc, command.after, names)
        case act.PasteIcons() if isinstance(value, tuple):
            return *_each(command.doc, value, names), *_of(command.doc, command.after, names)
        case act.SetLoop():
            return *_of(command.doc, command.test, names), *_of(command.doc, command.anchor, names)
        case act.RemoveIcons() | act.CopyIcons() | act.CutIcons() | act.SetBreakpoint() | act.RepeatSteps():
            return *_each(command.doc, command.steps, names), names.get(command.doc, ""), command.doc
        case act.EditIcon() | act.SetSynchTag() | act.RemoveLoop() | act.SetConditions():
            return *_of(command.doc, command.step, names), names.get(command.doc, ""), command.doc
        case act.SkipTo():
            return "", str(command.step), "", ""
    return None


def _inserted(command: act.InsertIcon | act.InsertBranch, value: object) -> tuple[str, str]:
    """What was inserted; where that was refused, it has its name as its id."""
    name = command.onikon if isinstance(command, act.InsertIcon) else "branch"
    return name, _id(command.doc, value) if value else name


def _id(doc: str, number: object) -> str:
    return f"{doc}/{number}"


def _of(doc: str, number: int, names: Mapping[str, str]) -> tuple[str, str]:
    return names.get(_id(doc, number), ""), _id(doc, number)


def _each(doc: str, numbers: Iterable[int], names: Mapping[str, str]) -> tuple[str, str]:
    ids = [_id(doc, number) for number in numbers]
    return ",".join(names.get(number, "") for number in ids), ",".join(ids)
