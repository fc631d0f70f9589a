"""What was cut or copied on the canvas, and its text, which travels by mail (requirements C10, C22)."""

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Annotated

import msgspec
from msgspec import Meta, Struct

from onika.files import conf
from onika.model.configuration import UNKNOWN_RTPU, Configuration, Group, Locus, Placed
from onika.model.own_lines import OwnLines
from onika.model.task import LocalLine
from onika.words.name import SVAR_NAME, TASK_NAME
from onika.words.reason import Reason

_VERSION = 1
_FAR = 10**9
"""Pixels: what a configuration file can say."""

_Pixels = Annotated[int, Meta(ge=-_FAR, le=_FAR)]


@dataclass(frozen=True, slots=True)
class Clipboard:
    """Tasks with their places, their supermodules and the loci of the variables that they use."""

    placed: tuple[Placed, ...] = ()
    loci: tuple[Locus, ...] = ()
    groups: tuple[Group, ...] = ()
    """The supermodules that are in it whole."""

    @property
    def corner(self) -> tuple[int, int]:
        """The upper left corner of all tasks; raises ValueError where there are none."""
        return min(placed.x for placed in self.placed), min(placed.y for placed in self.placed)

    def at(self, x: int, y: int) -> "Clipboard":
        """The same with its upper left corner elsewhere."""
        left, top = self.corner
        right, down = x - left, y - top
        placed = tuple(replace(placed, x=placed.x + right, y=placed.y + down) for placed in self.placed)
        loci = tuple(replace(locus, x=locus.x + right, y=locus.y + down) for locus in self.loci)
        return replace(self, placed=placed, loci=loci)


def copied(configuration: Configuration, names: Iterable[str], svars: Iterable[str]) -> Clipboard:
    """Some tasks of a configuration; `svars` are the variables that they use."""
    tasks, variables = set(names), set(svars)
    return Clipboard(
        tuple(placed for placed in configuration.placed if placed.task in tasks),
        tuple(locus for locus in configuration.loci if locus.svar in variables),
        tuple(group for group in configuration.groups if tasks.issuperset(group.tasks)),
    )


def write(copied: Clipboard) -> str:
    """The text of what was copied."""
    tasks = tuple(
        _Task(
            placed.task,
            placed.x,
            placed.y,
            placed.in_left,
            placed.frequency,
            placed.rtpu,
            placed.own.aliases,
            tuple((line.key, line.words) for line in placed.own.local),
            placed.own.without,
            placed.rmod,
        )
        for placed in copied.placed
    )
    loci = tuple(_Locus(locus.svar, locus.x, locus.y, locus.show) for locus in copied.loci)
    groups = tuple(_Group(group.name, group.tasks) for group in copied.groups)
    return msgspec.json.encode(_Text(_VERSION, tasks, loci, groups)).decode()


def read(text: str) -> Clipboard | Reason:
    """What a text holds; the reason where it was not copied from a configuration."""
    try:
        decoded = _DECODER.decode(text)
    except (msgspec.DecodeError, UnicodeEncodeError) as wrong:
        return Reason.of("desk.text_without_tasks", text=_beginning(text), why=str(wrong))
    if decoded.onika != _VERSION:
        return Reason.of("desk.tasks_of_version", version=decoded.onika)
    wrong_names = [task.task for task in decoded.tasks if not TASK_NAME.match(task.task)]
    wrong_names += [locus.svar for locus in decoded.loci if not SVAR_NAME.match(locus.svar)]
    wrong_names += [task.rtpu for task in decoded.tasks if not TASK_NAME.match(task.rtpu)]
    wrong_names += [group.name for group in decoded.groups if not TASK_NAME.match(group.name)]
    wrong_names += [task.task for task in decoded.tasks if not (task.placed().is_as_filed or task.is_sound())]
    if wrong_names:
        return Reason.of("desk.names_in_text", text=_beginning(wrong_names[0]))
    if any(not math.isfinite(task.hz) or task.hz < 0 for task in decoded.tasks):
        return Reason.of("desk.rates_in_text")
    return _unique(decoded)


class _Task(Struct, frozen=True):
    task: str
    x: _Pixels
    y: _Pixels
    in_left: bool = True
    hz: float = 0.0
    rtpu: str = UNKNOWN_RTPU
    aliases: tuple[tuple[str, str], ...] = ()
    local: tuple[tuple[str, tuple[str, ...]], ...] = ()
    without: tuple[str, ...] = ()
    rmod: str = ""

    def placed(self) -> Placed:
        """The task as it is placed."""
        local = tuple(LocalLine(key, words) for key, words in self.local)
        own = OwnLines(self.aliases, local, self.without)
        return Placed(self.task, self.x, self.y, self.in_left, self.hz, self.rtpu, own, self.rmod)

    def is_sound(self) -> bool:
        """Whether a file of a configuration could say it."""
        configuration = Configuration("c", (self.placed(),))
        return conf.read(conf.write(configuration), "c", "c")[0] == configuration


class _Locus(Struct, frozen=True):
    svar: str
    x: _Pixels
    y: _Pixels
    is_shown: bool = True


class _Group(Struct, frozen=True):
    name: str
    tasks: Annotated[tuple[str, ...], Meta(min_length=1)]


class _Text(Struct, frozen=True, omit_defaults=True):
    onika: int
    tasks: Annotated[tuple[_Task, ...], Meta(min_length=1)]
    loci: tuple[_Locus, ...] = ()
    groups: tuple[_Group, ...] = ()


_DECODER = msgspec.json.Decoder(_Text)


def _unique(decoded: _Text) -> Clipboard | Reason:
    twice = _repeated(task.task for task in decoded.tasks)
    if twice:
        return Reason.of("desk.task_twice", name=twice)
    stray = _stray(decoded)
    if stray:
        return Reason.of("desk.supermodules_in_text", text=_beginning(stray))
    placed = tuple(task.placed() for task in decoded.tasks)
    loci = {locus.svar: Locus(locus.svar, locus.x, locus.y, show=locus.is_shown) for locus in decoded.loci}
    groups = tuple(Group(group.name, group.tasks) for group in decoded.groups)
    return Clipboard(placed, tuple(loci.values()), groups)


def _stray(decoded: _Text) -> str | None:
    """What stands in no supermodule rightly: a task in two of them or in none that is there, or a name used twice."""
    tasks = {task.task for task in decoded.tasks}
    members = [task for group in decoded.groups for task in group.tasks]
    missing = next((task for task in members if task not in tasks), None)
    return missing or _repeated(members) or _repeated(group.name for group in decoded.groups)


def _repeated(names: Iterable[str]) -> str | None:
    """The first name that is there more than once."""
    return next((name for name, times in Counter(names).items() if times > 1), None)


def _beginning(text: str) -> str:
    return repr(text if len(text) <= 40 else text[:40] + "…")
