"""The users of a page: a file of lines `NAME ROLE HASH-OF-PASSWORD`, which may change while the page is served."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from onika.files import whole
from onika.files.state.state_directory import make_own, state_directory
from onika.link.caller import Role
from onika.web.access.password_hash import PasswordHash
from onika.words.fault import Fault, Place, Refusal
from onika.words.reason import Reason

ROLES = {role.word: role for role in Role}
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,31}")
_LEFT_OUT = Reason.of("desk.user_left_out")


@dataclass(frozen=True, slots=True)
class PageUser:
    """One user; of the password only the hash is known."""

    name: str
    role: Role
    password: PasswordHash

    def __str__(self) -> str:
        return f"{self.name} {self.role.word} {self.password}"


def users_path(environment: Mapping[str, str]) -> Path:
    """Where the file lies if nothing else is said: in the state directory."""
    return state_directory(environment) / "page-users"


def parsed(text: str, place: str) -> tuple[dict[str, PageUser], list[Fault]]:
    """The users in a file's text by name, and what is wrong with it; a line that is none lets nobody in."""
    users: dict[str, PageUser] = {}
    faults: list[Fault] = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        user = _user(words)
        if user is None:  # the line is not shown: somebody may have written a password there
            reason = Reason.of("desk.user_line", roles=tuple(ROLES))
            faults.append(Fault(Place(place, number), reason, _LEFT_OUT))
        elif user.name in users:
            faults.append(Fault(Place(place, number), Reason.of("desk.user_twice", name=user.name), _LEFT_OUT))
        else:
            users[user.name] = user
    return users, faults


class PageUserFile:
    """The file at a path; `users` are those of the last look."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.users: dict[str, PageUser] = {}
        self.faults: tuple[Fault, ...] = ()
        self._seen: tuple[int, int, int] | None = (0, 0, 0)

    def look(self) -> bool:
        """Read it anew where it has changed, and say whether it had; a file that is gone has no users."""
        seen = self._mark()
        if seen == self._seen:
            return False
        self._seen = seen
        content, faults = whole.read(self.path) if seen is not None else (None, ())
        users, wrong = parsed("" if content is None else content[0], str(self.path))
        self.users, self.faults = users, (*faults, *wrong)
        return True

    def put(self, user: PageUser) -> Refusal | None:
        """Add a user, or change one; the others stay. Raises OSError."""
        return self._write({**self._now(), user.name: user}.values())

    def remove(self, name: str) -> Refusal | None:
        """Let a user in no more; raises OSError."""
        return self._write(user for user in self._now().values() if user.name != name)

    def _now(self) -> dict[str, PageUser]:
        self.look()
        return self.users

    def _write(self, users: Iterable[PageUser]) -> Refusal | None:
        make_own(self.path.parent)
        if not self.path.exists():
            self.path.touch(0o600)
        text = "".join(f"{user}\n" for user in users)
        written = whole.write(self.path, text, whole.ANYTHING)
        return written if isinstance(written, Refusal) else None

    def _mark(self) -> tuple[int, int, int] | None:
        """What tells one content of the file from another; None: there is none."""
        try:
            status = self.path.stat()
        except OSError:
            return None
        return status.st_ino, status.st_mtime_ns, status.st_size


def _user(words: list[str]) -> PageUser | None:
    if len(words) != 3 or not NAME.fullmatch(words[0]) or words[1] not in ROLES:
        return None
    try:
        return PageUser(words[0], ROLES[words[1]], PasswordHash.parse(words[2]))
    except ValueError:
        return None
