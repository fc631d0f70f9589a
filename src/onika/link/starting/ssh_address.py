"""The address of a runtime that is started by ssh: `ssh://[USER@]HOST[:PORT][/PROGRAM][?virtual&stay&unit=rt0]` (A15).

HOST is whatever the user's own ssh knows, so also a name of its configuration. PROGRAM is the path of `onika` there,
where it lies on no path that a command by ssh finds. What stands after the question mark says what is started:

    virtual     in virtual time
    stay        it stays when the connection ends; whoever comes again by such an address finds it
    unit=NAME   with this processing unit; more than one may be named
"""

import re
import shlex
from dataclasses import dataclass
from urllib.parse import SplitResult, parse_qsl, urlsplit

from onika.words.name import TASK_NAME
from onika.words.reason import Reason

SCHEME = "ssh"
_HOST = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*|[0-9A-Fa-f:.]+(%[A-Za-z0-9]+)?")
_USER = re.compile(r"[A-Za-z_][A-Za-z0-9._-]*")
_PROGRAM = re.compile(r"/[A-Za-z0-9._/+-]+")
_PROGRAM_NAME = "onika"
_WAYS = ("virtual", "stay")


@dataclass(frozen=True, slots=True)
class SshAddress:
    """Where ssh goes, and what it starts there."""

    host: str
    user: str = ""
    port: int | None = None
    program: str = ""
    is_virtual: bool = False
    stays: bool = False
    units: tuple[str, ...] = ()

    def __str__(self) -> str:
        user = f"{self.user}@" if self.user else ""
        host = f"[{self.host}]" if ":" in self.host else self.host
        port = "" if self.port is None else f":{self.port}"
        ways = ["virtual"] * self.is_virtual + ["stay"] * self.stays + [f"unit={unit}" for unit in self.units]
        return f"{SCHEME}://{user}{host}{port}{self.program}{'?' if ways else ''}{'&'.join(ways)}"

    @classmethod
    def parse(cls, text: str) -> "SshAddress":
        """Read an address; raises ValueError that says what was expected and found.

        Nothing is let through that ssh could take for an option, or a shell for more than a word.
        """
        try:
            parts = urlsplit(text)
            port = parts.port
        except ValueError:
            raise ValueError(Reason.of("link.ssh_address_form", text=text)) from None
        program = parts.path.removesuffix("/")
        if port == 0 or parts.password is not None or parts.fragment or not _fits(parts, program):
            raise ValueError(Reason.of("link.ssh_address_form", text=text))
        words = parse_qsl(parts.query, keep_blank_values=True)
        unknown = _unknown(words)
        if unknown:
            raise ValueError(Reason.of("link.ssh_address_words", word=unknown[0], text=text))
        ways = {word for word, _ in words}
        units = tuple(dict.fromkeys(value for word, value in words if word == "unit"))
        return cls(parts.hostname or "", parts.username or "", port, program, "virtual" in ways, "stay" in ways, units)

    @property
    def place(self) -> tuple[str, ...]:
        """The words for ssh that name where to, behind everything that is an option."""
        port = () if self.port is None else ("-p", str(self.port))
        user = ("-l", self.user) if self.user else ()
        return (*port, *user, "--", self.host)

    @property
    def command(self) -> str:
        """The command that is carried out there, as a shell reads it."""
        words = [self.program or _PROGRAM_NAME, "runtime", "--hand-over"]
        words += ["--virtual"] * self.is_virtual + ["--stay"] * self.stays
        words += [word for unit in self.units for word in ("--rtpu", unit)]
        return shlex.join(words)


def _fits(parts: SplitResult, program: str) -> bool:
    """Whether each part is what it may be."""
    user = parts.username or ""
    return (
        parts.scheme == SCHEME
        and _HOST.fullmatch(parts.hostname or "") is not None
        and (not user or _USER.fullmatch(user) is not None)
        and (not program or _PROGRAM.fullmatch(program) is not None)
    )


def _unknown(words: list[tuple[str, str]]) -> list[str]:
    """The words that say nothing of what is to be started."""
    unknown = [word for word, value in words if word != "unit" and (word not in _WAYS or value)]
    return unknown + [value or word for word, value in words if word == "unit" and not TASK_NAME.match(value)]
