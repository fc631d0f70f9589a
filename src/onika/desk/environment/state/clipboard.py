"""What was cut or copied, and its text, which travels by mail (requirements C10, C22)."""

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Annotated

import msgspec
from msgspec import Meta, Struct

from onika.model.configuration import UNKNOWN_RTPU, Configuration, Group, Locus, Placed
from onika.words.name import SVAR_NAME, TASK_NAME

_VERSION = 1
_FAR = 10**9
"""Pixels: what a configuration file can say."""

_Pixels = Annotated[int, Meta(ge=-_FAR, le=_FAR)]


@dataclass(frozen=True, slots=True)
class Copied:
    """Tasks with their places, and the loci of the variables that they use."""

    placed: tuple[Placed, ...] = ()
    loci: tuple[Locus, ...] = ()
    groups: tuple[Group, ...] = ()
    """The supermodules that are in it whole."""

    @property
    def corner(self) -> tuple[int, int]:
        """The upper left corner of all tasks; raises ValueError where there are none."""
        return min(one.x for one in self.placed), min(one.y for one in self.placed)

    def at(self, x: int, y: int) -> "Copied":
        """The same with its upper left corner elsewhere."""
        left, top = self.corner
        right, down = x - left, y - top
        placed = tuple(replace(one, x=one.x + right, y=one.y + down) for one in self.placed)
        loci = tuple(replace(one, x=one.x + right, y=one.y + down) for one in self.loci)
        return replace(self, placed=placed, loci=loci)


def copied(configuration: Configuration, names: Iterable[str], svars: Iterable[str]) -> Copied:
    """Some tasks of a configuration; `svars` are the variables that they use."""
    tasks, variables = set(names), set(svars)
    return Copied(
        tuple(one for one in configuration.placed if one.task in tasks),
        tuple(one for one in configuration.loci if one.svar in variables),
        tuple(one for one in configuration.groups if tasks.issuperset(one.tasks)),
    )


def write(found: Copied) -> str:
    """The text of what was copied."""
    tasks = tuple(_Task(one.task, one.x, one.y, one.in_left, one.frequency, one.rtpu) for one in found.placed)
    loci = tuple(_Locus(one.svar, one.x, one.y, one.show) for one in found.loci)
    groups = tuple(_Group(one.name, one.tasks) for one in found.groups)
    return msgspec.json.encode(_Text(_VERSION, tasks, loci, groups)).decode()


def read(text: str) -> Copied | str:
    """What a text holds; a sentence where it was not copied from a configuration."""
    try:
        found = _DECODER.decode(text)
    except (msgspec.DecodeError, UnicodeEncodeError) as wrong:
        return f"expected tasks that were copied from a configuration, found {_beginning(text)} ({wrong})"
    if found.onika != _VERSION:
        return f"expected tasks as this version copies them, found those of version {found.onika}"
    wrong_names = [one.task for one in found.tasks if not TASK_NAME.match(one.task)]
    wrong_names += [one.svar for one in found.loci if not SVAR_NAME.match(one.svar)]
    wrong_names += [one.rtpu for one in found.tasks if not TASK_NAME.match(one.rtpu)]
    wrong_names += [one.name for one in found.groups if not TASK_NAME.match(one.name)]
    if wrong_names:
        return f"expected names of tasks, units and variables, found {_beginning(wrong_names[0])}"
    if any(not math.isfinite(one.hz) or one.hz < 0 for one in found.tasks):
        return "expected rates of at least 0 Hz, found another"
    return _unique(found)


class _Task(Struct, frozen=True):
    task: str
    x: _Pixels
    y: _Pixels
    in_left: bool = True
    hz: float = 0.0
    rtpu: str = UNKNOWN_RTPU


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


def _unique(found: _Text) -> Copied | str:
    count = Counter(one.task for one in found.tasks)
    twice = next((name for name, times in count.items() if times > 1), None)
    if twice:
        return f"expected every task once, found {twice} again"
    loci = {one.svar: Locus(one.svar, one.x, one.y, show=one.is_shown) for one in found.loci}
    placed = (Placed(one.task, one.x, one.y, one.in_left, one.hz, one.rtpu) for one in found.tasks)
    members = Counter(task for one in found.groups for task in one.tasks)
    stray = next((task for task, times in members.items() if times > 1 or task not in count), None)
    names = Counter(one.name for one in found.groups)
    stray = stray or next((name for name, times in names.items() if times > 1), None)
    if stray:
        return f"expected supermodules of these tasks, each in one of them, found {_beginning(stray)}"
    groups = tuple(Group(one.name, one.tasks) for one in found.groups)
    return Copied(tuple(placed), tuple(loci.values()), groups)


def _beginning(text: str) -> str:
    return repr(text if len(text) <= 40 else text[:40] + "…")
