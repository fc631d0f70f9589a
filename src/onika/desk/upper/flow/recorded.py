"""Acts on applications as the diary knows them: which icon, and the icon it was put behind (requirement H01, §E.2)."""

from collections.abc import Iterable, Mapping

from onika.desk.environment.model import Model
from onika.model.application import Branch, Icon
from onika.model.flow_path import spots
from onika.wire import act

Things = tuple[str, str, str, str]
"""Object, its id, associated object, its id."""


def names_in(model: Model, docs: Iterable[str]) -> dict[str, str]:
    """What applications are called, and by their ids, `a1/17`, the steps of those among `docs`."""
    found = {one.id: one.name for one in model.applications.values()}
    for doc in docs:
        if opened := model.applications.get(doc):
            found[f"{doc}/0"] = "Start"
            for number, spot in spots(opened.application).items():
                step = spot.step
                kind = "branch" if isinstance(step, Branch) else "hole"
                found[f"{doc}/{number}"] = step.onikon.name if isinstance(step, Icon) else kind
    return found


def things(asked: act.AnyAct, value: object, names: Mapping[str, str]) -> Things | None:
    """What an act on an application was about; None: its document alone, or it is none."""
    match asked:
        case act.NewApplication():
            doc = str(value or "")
            return names.get(doc, ""), doc, "", ""
        case act.InsertIcon() | act.InsertBranch():
            name = asked.onikon if isinstance(asked, act.InsertIcon) else "branch"
            return name, _id(asked.doc, value) if value else name, *_of(asked.doc, asked.after, names)
        case act.ExchangeIcon():
            return asked.onikon, _id(asked.doc, asked.step), names.get(asked.doc, ""), asked.doc
        case act.MoveIcons():
            return *_each(asked.doc, asked.steps, names), *_of(asked.doc, asked.after, names)
        case act.PasteIcons() if isinstance(value, tuple):
            return *_each(asked.doc, value, names), *_of(asked.doc, asked.after, names)
        case act.SetLoop():
            return *_of(asked.doc, asked.test, names), *_of(asked.doc, asked.anchor, names)
        case act.RemoveIcons() | act.CopyIcons() | act.CutIcons() | act.SetBreakpoint():
            return *_each(asked.doc, asked.steps, names), names.get(asked.doc, ""), asked.doc
        case act.EditIcon() | act.SetSynchTag() | act.RemoveLoop() | act.SetConditions():
            return *_of(asked.doc, asked.step, names), names.get(asked.doc, ""), asked.doc
        case act.SkipTo():
            return "", str(asked.step), "", ""
    return None


def _id(doc: str, number: object) -> str:
    return f"{doc}/{number}"


def _of(doc: str, number: int, names: Mapping[str, str]) -> tuple[str, str]:
    return names.get(_id(doc, number), ""), _id(doc, number)


def _each(doc: str, numbers: Iterable[int], names: Mapping[str, str]) -> tuple[str, str]:
    ids = [_id(doc, number) for number in numbers]
    return ",".join(names.get(one, "") for one in ids), ",".join(ids)
