"""The users of a runtime: a file of lines `NAME ROLE SHA256-OF-TOKEN`; as a program it makes such a line."""

import hmac
import re
import sys
from dataclasses import dataclass
from pathlib import Path

from onika.link.caller import Role
from onika.link.token import digest, new_token
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_ROLES = {role.word: role for role in Role}
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,31}")
_DIGEST = re.compile(r"[0-9a-f]{64}")


@dataclass(frozen=True, slots=True)
class User:
    """One user; of his token only the SHA-256 is known."""

    name: str
    role: Role
    digest: str

    def __str__(self) -> str:
        return f"{self.name} {self.role.word} {self.digest}"


class Users:
    """All users of a runtime."""

    def __init__(self, users: tuple[User, ...]) -> None:
        self.users = users

    def find(self, token: str) -> User | None:
        """The user whose token this is; takes as long for a wrong one as for a right one."""
        wanted = digest(token)
        users = [user for user in self.users if hmac.compare_digest(user.digest, wanted)]
        return users[0] if users else None


def read(text: str, place: str) -> tuple[tuple[User, ...], list[Fault]]:
    """The users in a file's text and what is wrong with it; empty lines and those with a `#` first do not count."""
    users: list[User] = []
    faults: list[Fault] = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        user = _user(words)
        if user is None:
            # the line is not shown: somebody may have written a token there
            reason = Reason.of("host.user_line", roles=tuple(_ROLES), count=len(words))
            faults.append(Fault(Place(place, number), reason, Reason.of("host.nobody_let_in")))
        elif any(user.name == other.name and user.role is not other.role for other in users):
            reason = Reason.of("host.user_twice", name=user.name, role=user.role.word)
            faults.append(Fault(Place(place, number), reason, Reason.of("host.nobody_let_in")))
        else:
            users.append(user)
    return tuple(users), faults


def add_user(path: Path, name: str, role: str) -> str:
    """Add a user to a file, or one more token of his, and give the token, which is kept nowhere; raises ValueError
    for what is no name or role, OSError where the file cannot be written.
    """
    if not _NAME.fullmatch(name) or role not in _ROLES:
        raise ValueError(Reason.of("host.user_name", name=name[:80], roles=tuple(_ROLES)))
    known = path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""
    users, faults = read(known, str(path))
    other = next((user for user in users if user.name == name and user.role is not _ROLES[role]), None)
    if faults or other is not None:
        twice = Reason.of("host.user_twice", name=name, role=role)
        raise ValueError(faults[0].sentence if faults else twice)
    token = new_token()
    with path.open("a", encoding="ascii") as file:
        file.write("\n" * (known[-1:] not in ("", "\n")) + f"{User(name, _ROLES[role], digest(token))}\n")
    return token


def main(words: list[str]) -> int:
    """`python -m onika.host.sessions.users NAME ROLE [FILE]`: print a new token once and add its line to the file."""
    if len(words) not in (2, 3) or not _NAME.fullmatch(words[0]) or words[1] not in _ROLES:
        sys.stderr.write(f"expected NAME {'|'.join(_ROLES)} [FILE]\n")
        return 2
    if len(words) == 3:
        sys.stdout.write(f"{add_user(Path(words[2]), words[0], words[1])}\n")
        return 0
    token = new_token()
    sys.stdout.write(f"{User(words[0], _ROLES[words[1]], digest(token))}\n{token}\n")
    return 0


def _user(words: list[str]) -> User | None:
    if len(words) != 3 or not _NAME.fullmatch(words[0]) or words[1] not in _ROLES or not _DIGEST.fullmatch(words[2]):
        return None
    return User(words[0], _ROLES[words[1]], words[2])


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
