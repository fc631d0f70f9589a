"""A redirection: the task, or the world, that stands for another in a run (requirement E09, §5.9.1).

The application's file stays as it is. A world is written with its colon, as a device is: `boxes:=boxes@copy:`.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from onika.words.name import TASK_NAME, WORLD_NAME
from onika.words.reason import Reason

_FORM = re.compile(r"(?:(?P<flow>[^:=\s]+):)?(?P<old>[^:=\s]+:?)=(?P<new>[^:=\s]+:?)\Z")
_NUMBER = re.compile(r"[0-9]{1,6}\Z")


@dataclass(frozen=True, slots=True)
class Redirect:
    """Wherever `old` would live, `new` does, in one flow with all that is nested in it or in every flow.

    Both are tasks, or both are worlds, whose names end with a colon: then the devices of `old` are those of `new`.
    """

    old: str
    new: str
    flow: str = ""
    """The number of a flow or its subsystem; empty: every flow."""

    @classmethod
    def parse(cls, text: str) -> "Redirect":
        """Read `puma=scara`, `0:puma=scara` or `0:cell:=boxes:`; raises ValueError that says what was expected."""
        match = _FORM.match(text.strip())
        if not match or not (_are_tasks(match["old"], match["new"]) or _are_worlds(match["old"], match["new"])):
            raise ValueError(Reason.of("rules.redirect_form", text=text))
        return cls(match["old"], match["new"], match["flow"] or "")

    @property
    def is_of_world(self) -> bool:
        """Whether a world stands for a world."""
        return self.old.endswith(":")

    @property
    def home(self) -> str:
        """The subsystem it is meant for; empty: every one."""
        if _NUMBER.match(self.flow):
            return f"flow{int(self.flow)}"
        return self.flow

    def holds_in(self, subsystem: str) -> bool:
        """Whether it holds in a subsystem: in `flow0` means in `flow0.1` too, which is nested there."""
        return not self.home or f"{subsystem}.".startswith(f"{self.home}.")

    def __str__(self) -> str:
        if self.flow:
            return f"{self.flow}:{self.old}={self.new}"
        return f"{self.old}={self.new}"


Choice = dict[str, str]
"""What stands for what in one flow, by the names of the replaced tasks."""

WorldChoice = dict[str, str]
"""Which world stands for which in one flow; here without their colons."""


def choice(redirects: Sequence[Redirect], subsystem: str) -> Choice:
    """What stands for what in a subsystem: what is said of it alone comes before what is said of all."""
    effective = _effective(redirects, subsystem)
    return {redirect.old: redirect.new for redirect in effective if not redirect.is_of_world}


def world_choice(redirects: Sequence[Redirect], subsystem: str) -> WorldChoice:
    """Which world stands for which in a subsystem: what is said of it alone comes before what is said of all."""
    effective = _effective(redirects, subsystem)
    return {redirect.old[:-1]: redirect.new[:-1] for redirect in effective if redirect.is_of_world}


def _effective(redirects: Sequence[Redirect], subsystem: str) -> list[Redirect]:
    """Those that hold there and change something, each after those that it overrules."""
    general_first = sorted(redirects, key=lambda redirect: len(redirect.home))
    last = {redirect.old: redirect for redirect in general_first if redirect.holds_in(subsystem)}
    return [redirect for redirect in last.values() if redirect.old != redirect.new]


def _are_tasks(*names: str) -> bool:
    return all(map(TASK_NAME.match, names))


def _are_worlds(*names: str) -> bool:
    return all(name.endswith(":") and WORLD_NAME.match(name[:-1]) for name in names)
