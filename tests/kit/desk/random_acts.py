"""Acts as a user may do them, drawn at random with a seed: sensible ones and such that are refused."""

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from kit.desk.app_fixture import JOINTS, ONIKONS, AppFixture
from onika.model.initials import drawn
from onika.wire import act

ICONS = tuple(icon.name for icon in ONIKONS)
DIGITS = "".join(drawn("s").rows)
Edge = Literal["left", "right", "top", "bottom", "columns", "rows"]
EDGES: tuple[Edge, ...] = (
    "left",
    "right",
    "top",
    "bottom",
    "columns",
    "rows",
)


@dataclass
class RandomUser:
    """Draws the next act from what is open.

    seed    the same acts come of the same seed, among the same surroundings
    base    where things are saved
    tasks   those that may be placed
    """

    seed: int
    session: AppFixture
    base: str
    tasks: tuple[str, ...]

    def __post_init__(self) -> None:
        self.random = random.Random(self.seed)

    def next(self) -> act.AnyAct:
        """The next act."""
        makers: list[Callable[[], act.AnyAct]] = [self._whole, self._own]
        makers += [self._in_application] * 6 if self.session.environment.model.applications else [self._new]
        makers += [self._in_configuration] * 6 if self.session.environment.model.documents else [self._new]
        return self.random.choice(makers)()

    def _new(self) -> act.AnyAct:
        return self._one_of(act.New(), act.NewApplication(self.random.randint(0, 3)))

    def _one_of(self, *acts: act.AnyAct) -> act.AnyAct:
        return self.random.choice(acts)

    def _whole(self) -> act.AnyAct:
        model, draw = self.session.environment.model, self.random
        ids = [file.id for file in model.open_files] or ["c99"]
        paths = [*model.files, *model.application_files, "nowhere"]
        doc = draw.choice(ids)
        return self._one_of(
            act.New(), act.Open(draw.choice(paths)), act.Undo(doc), act.Redo(doc), act.Undo(""), act.Redo(""),
            act.Save(doc), act.Save(doc, f"made{draw.randint(0, 3)}", self.base, draw.random() < 0.5),
            act.Close(doc, discards=draw.random() < 0.5), act.Reload(doc), act.Check(doc),
        )  # fmt: skip

    def _own(self) -> act.AnyAct:
        draw = self.random
        icon, other, task = draw.choice(ICONS), draw.choice(ICONS), draw.choice(self.tasks)
        values = tuple(tuple(str(round(draw.uniform(-1, 1), 3)) for _ in items) for items in JOINTS)
        return self._one_of(
            act.Prefer({"min_size": draw.randint(-2, 90), "shows_warnings": draw.random() < 0.5}),
            act.MakeTarget(f"spot{draw.randint(0, 2)}", "Joint object", values, DIGITS, "a spot", self.base),
            act.EditOnikon(icon, f"words {draw.randint(0, 9)} \u00e9\t\u2028"),
            act.RemoveOnikon(icon, draw.random() < 0.2),
            act.ArrangeIcon(icon, other), act.ArrangeTask(task, draw.choice(self.tasks)),
            act.Local(task, (("GAIN", (str(draw.randint(0, 9)),)),)), act.SaveTask(task), act.ForgetTask(task),
            act.LibraryRate(task, draw.choice([0.0, 25.0, -1.0])), act.Note("select_icon", icon, icon, window="dict"),
            act.NewModule(f"module{draw.randint(0, 2)}", self.base),
        )  # fmt: skip

    def _in_application(self) -> act.AnyAct:
        draw, model = self.random, self.session.environment.model
        opened = draw.choice(list(model.applications.values()))
        doc = opened.id
        numbers = [step.number for flow in opened.application.flows for step in flow.steps] or [0]
        step, other = draw.choice(numbers), draw.choice([0, *numbers])
        steps = tuple(draw.sample(numbers, min(len(numbers), draw.randint(1, 3))))
        icon = draw.choice(ICONS)
        return self._one_of(
            act.InsertIcon(doc, icon, "0", other), act.InsertIcon(doc, icon, "0", other), act.InsertIcon(doc, icon),
            act.InsertBranch(doc, "0", other), act.ExchangeIcon(doc, step, icon), act.RemoveIcons(doc, steps),
            act.MoveIcons(doc, steps, "0", other), act.CopyIcons(doc, steps), act.CutIcons(doc, steps),
            act.PasteIcons(doc, "0", other), act.EditIcon(doc, step, f"edited {draw.randint(0, 9)}"),
            act.SetBreakpoint(doc, steps), act.SetSynchTag(doc, step, draw.choice(["", "a", "b"])),
            act.SetLoop(doc, step, other), act.RemoveLoop(doc, step), act.AddFlow(doc), act.RemoveFlow(doc, "1"),
            act.SetParallel(doc, draw.random() < 0.5), act.RepeatSteps(doc, steps, draw.randint(0, 4)),
        )  # fmt: skip

    def _in_configuration(self) -> act.AnyAct:
        draw, model = self.random, self.session.environment.model
        document = draw.choice(list(model.documents.values()))
        doc = document.id
        there = [placed.task for placed in document.content.configuration.placed] or ["gone"]
        tasks = tuple(draw.sample(there, min(len(there), draw.randint(1, 3))))
        task = draw.choice(self.tasks)
        x, y = draw.randint(-50, 900), draw.randint(-50, 900)
        return self._one_of(
            act.Place(doc, task, x, y), act.Place(doc, task, x, y), act.Move(doc, {tasks[0]: (x, y)}),
            act.Remove(doc, tasks), act.Flip(doc, tasks), act.Align(doc, tasks, draw.choice(EDGES)), act.Arrange(doc),
            act.Copy(doc, tasks), act.Cut(doc, tasks), act.Paste(doc, x, y), act.Exchange(doc, tasks[0], task),
            act.Show(doc, ("Q_REF", "T"), draw.random() < 0.5), act.Group(doc, f"g{draw.randint(0, 2)}", tasks),
            act.Ungroup(doc, "g1"), act.SaveGroup(doc, "g1", self.base),
            act.Rate(doc, tasks[0], draw.choice([0.0, 33.0])),
            act.Alias(task, "Q_REF", draw.choice(["Q_2", ""]), doc), act.Local(task, (("GAIN", ("4",)),), doc),
        )  # fmt: skip
