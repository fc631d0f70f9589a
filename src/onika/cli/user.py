"""`onika user`: who may come to a page that is served to others, to a runtime or to a site (requirements F02, F10)."""

import argparse
import getpass
import os
import sys
from pathlib import Path

from onika.cli.language import say
from onika.web.access.page_users import NAME, ROLES, PageUser, PageUserFile, users_path
from onika.web.access.password_hash import PasswordHash, unfit
from onika.words.fault import Refusal
from onika.words.reason import Reason, reason_of


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_user")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    add = acts.add_parser("add", help=say(Reason.of("cli.user_add")))
    add.add_argument("name", metavar="NAME")
    add.add_argument("role", choices=tuple(ROLES), help=say(Reason.of("cli.user_role")))
    remove = acts.add_parser("remove", help=say(Reason.of("cli.user_remove")))
    remove.add_argument("name", metavar="NAME")
    listed = acts.add_parser("list", help=say(Reason.of("cli.user_list")))
    for each in (add, remove, listed):
        each.add_argument("--users", type=Path, metavar="FILE", help=say(Reason.of("cli.user_file")))
    token = acts.add_parser("token", help=say(Reason.of("cli.user_token")))
    token.add_argument("name", metavar="NAME")
    token.add_argument("role", choices=tuple(ROLES), help=say(Reason.of("cli.user_role_there")))
    token.add_argument("--users", type=Path, required=True, metavar="FILE", help=say(Reason.of("cli.user_token_file")))


def carry_out(given: argparse.Namespace) -> int:
    """Add, remove or list; 0 where that could be done."""
    if given.act == "token":
        return _token(given.users, given.name, given.role)
    file = PageUserFile(given.users or users_path(os.environ))
    file.look()
    for fault in file.faults:
        print(say(fault.sentence), file=sys.stderr)
    if given.act == "list":
        return _list(file)
    if file.faults:
        return 1  # writing the file anew would lose those lines
    return _remove(file, given.name) if given.act == "remove" else _add(file, given.name, given.role)


def _list(file: PageUserFile) -> int:
    for user in file.users.values():
        print(f"{user.name}  {user.role.word}")
    if not file.users:
        print(say(Reason.of("cli.no_page_user", path=str(file.path))), file=sys.stderr)
    return 1 if file.faults else 0


def _remove(file: PageUserFile, name: str) -> int:
    if name not in file.users:
        return _no(Reason.of("cli.no_such_user", name=name, names=tuple(file.users)))
    return _written(file.remove(name), Reason.of("cli.user_removed", name=name))


def _add(file: PageUserFile, name: str, role: str) -> int:
    if not NAME.fullmatch(name):
        return _no(Reason.of("cli.user_name", name=name))
    password = _password(name)
    why = Reason.of("cli.passwords_differ") if password is None else unfit(password, name)
    if why or password is None:
        return _no(why)
    key = "cli.user_changed" if name in file.users else "cli.user_added"
    user = PageUser(name, ROLES[role], PasswordHash.of(password))
    return _written(file.put(user), Reason.of(key, name=name, role=role))


def _token(path: Path, name: str, role: str) -> int:
    """The token alone on the output, so that it can go into a file."""
    from onika.host.sessions.users import add_user  # within: a page's users need nothing of runtimes

    try:
        token = add_user(path, name, role)
    except (OSError, ValueError) as wrong:
        return _no(reason_of(wrong))
    print(token)
    print(say(Reason.of("cli.user_token_added", name=name, role=role, path=str(path))), file=sys.stderr)
    return 0


def _password(name: str) -> str | None:
    """Typed twice at a terminal, else the first line that comes; None: the two are not the same."""
    if not sys.stdin.isatty():
        return sys.stdin.readline().rstrip("\n")
    first = getpass.getpass(say(Reason.of("cli.user_password", name=name)))
    return first if getpass.getpass(say(Reason.of("cli.user_password_again"))) == first else None


def _written(refusal: Refusal | None, done: Reason) -> int:
    if refusal is not None:
        return _no(refusal.reason)
    print(say(done))
    return 0


def _no(why: Reason) -> int:
    print(say(why), file=sys.stderr)
    return 1
