"""A redirection: the task that stands for another in a run, whose file stays as it is (requirement E09, §5.9.1)."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from onika.words.name import TASK_NAME
from onika.words.reason import Reason

_FORM = re.compile(r"(?:(?P<flow>[^:=\s]+):)?(?P<old>[^:=\s]+)=(?P<new>[^:=\s]+)\Z")
_NUMBER = re.compile(r"[0-9]{1,6}\Z")


@dataclass(frozen=True, slots=True)
class Redirect:
    """Wherever `old` would live, `new` does, in one flow with all that is nested in it or in every flow."""

    old: str
    new: str
    flow: str = ""
    """The number of a flow or its subsystem; empty: every flow."""

    @classmethod
    def parse(cls, text: str) -> "Redirect":
        """Read `puma=scara` or `0:puma=scara`; raises ValueError that says what was expected."""
        match = _FORM.match(text.strip())
        if not match or not (TASK_NAME.match(match["old"]) and TASK_NAME.match(match["new"])):
            raise ValueError(Reason.of("rules.redirect_form", text=text))
        return cls(match["old"], match["new"], match["flow"] or "")

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


def choice(redirects: Sequence[Redirect], subsystem: str) -> Choice:
    """What stands for what in a subsystem: what is said of it alone comes before what is said of all."""
    effective = sorted(
        (redirect for redirect in redirects if redirect.holds_in(subsystem)), key=lambda redirect: len(redirect.home)
    )
    return {redirect.old: redirect.new for redirect in effective if redirect.old != redirect.new}
