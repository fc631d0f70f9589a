"""`onika library`: publish a base directory, and use libraries of others (requirements F03, F06, X16)."""

import argparse
import getpass
import sys
from collections.abc import Callable, Mapping
from datetime import UTC, date, datetime
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.library import listing_text, sending
from onika.cli.lines.consent import agrees
from onika.cli.search_path import access_here
from onika.files.library_lock import LockedLibrary
from onika.store.remote.contents import contents, matching
from onika.store.remote.library_changes import changes
from onika.store.remote.lock_file import LockFile
from onika.store.remote.publication import DAYS, Publisher, fingerprint_of
from onika.store.remote.remote_libraries import Offer, RemoteLibraries
from onika.store.site import OWN
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason_with_place


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_library")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    publish = acts.add_parser("publish", help=say(Reason.of("cli.library_publish")))
    publish.add_argument("base", type=directory, metavar="DIR")
    publish.add_argument("--to", type=Path, required=True, metavar="FOLDER", help=say(Reason.of("cli.library_to")))
    publish.add_argument("--key", type=Path, required=True, metavar="KEY", help=say(Reason.of("cli.library_key")))
    publish.add_argument("--name", metavar="NAME", help=say(Reason.of("cli.library_name")))
    publish.add_argument("--desc", default="", metavar="TEXT", help=say(Reason.of("cli.library_desc")))
    publish.add_argument("--days", type=_days, default=DAYS, metavar="N", help=say(Reason.of("cli.library_days")))
    publish.add_argument("--next-key", type=Path, metavar="KEY.pub", help=say(Reason.of("cli.library_next_key")))
    add = _subscriber(acts.add_parser("add", help=say(Reason.of("cli.library_add"))))
    add.add_argument("address", metavar="URL|PATH")
    add.add_argument("--trust", default="", metavar="SHA256:…", help=say(Reason.of("cli.library_trust_option")))
    _subscriber(acts.add_parser("list", help=say(Reason.of("cli.library_list"))))
    update = _subscriber(acts.add_parser("update", help=say(Reason.of("cli.library_update"))))
    update.add_argument("name", nargs="*", metavar="NAME")
    update.add_argument("--agree", action="store_true", help=say(Reason.of("cli.library_agree")))
    fetch = _subscriber(acts.add_parser("fetch", help=say(Reason.of("cli.library_fetch"))))
    fetch.add_argument("name", nargs="*", metavar="NAME")
    browse = _subscriber(acts.add_parser("browse", help=say(Reason.of("cli.library_browse"))))
    browse.add_argument("address", metavar="NAME|URL|PATH")
    browse.add_argument("--search", default="", metavar="WORDS", help=say(Reason.of("cli.library_search")))
    sending.describe(_subscriber(acts.add_parser("send", help=say(Reason.of("cli.library_send")))))
    remove = _subscriber(acts.add_parser("remove", help=say(Reason.of("cli.library_remove"))))
    remove.add_argument("name", metavar="NAME")
    trust = _subscriber(acts.add_parser("trust", help=say(Reason.of("cli.library_trust"))))
    trust.add_argument("name", metavar="NAME")
    trust.add_argument("signer", metavar="SHA256:…")
    rights = _subscriber(acts.add_parser("rights", help=say(Reason.of("cli.library_rights"))))
    rights.add_argument("name", metavar="NAME")
    rights.add_argument("rights", choices=("all", "compute"))


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 0 where all of it could be done, 1 where something was refused."""
    if given.act == "publish":
        return _publish(given)
    access = access_here()
    base = Path(given.local) if given.local else Path.home() / OWN
    try:
        return _ACTS[given.act](given, RemoteLibraries(LockFile(base.absolute()), access))
    finally:
        access.close()


def _publish(given: argparse.Namespace) -> int:
    base = Path(given.base).absolute()
    next_key = ""
    if given.next_key is not None:
        try:
            next_key = fingerprint_of(given.next_key) or ""
        except OSError as error:
            return _no(system_reason_with_place(error))
        if not next_key:
            return _no(Reason.of("cli.library_no_key", path=str(given.next_key)))
    publisher = Publisher(base, given.to.absolute(), given.key, given.name or base.name)
    done = publisher.publish(_today(), days=given.days, description=given.desc, next_key=next_key)
    if isinstance(done, Reason):
        return _no(done)
    for line in listing_text.published(done, given.to):
        print(say(line))
    return 0


def _add(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    address = given.address if "://" in given.address else str(Path(given.address).expanduser().absolute())
    offer = libraries.offer(address, _today())
    if isinstance(offer, Reason):
        return _no(offer)
    for line in listing_text.offered(offer):
        print(say(line))
    if not _is_trusted(offer, given.trust):
        return _no(Reason.of("cli.library_not_trusted", signer=offer.found.signer))
    libraries.lock.base.mkdir(parents=True, exist_ok=True)
    added = libraries.add(offer, _who())
    if isinstance(added, Refusal):
        return _no(added.sentence)
    print(say(Reason.of("cli.library_added", library=added.name, path=str(libraries.lock.path))))
    return 0


def _is_trusted(offer: Offer, trusted: str) -> bool:
    """Whether the user trusts the signer: said with the command, or asked for at a terminal."""
    if trusted or not sys.stdin.isatty():
        return trusted == offer.found.signer
    return agrees(say(Reason.of("cli.library_trust_question")))


def _list(_: argparse.Namespace, libraries: RemoteLibraries) -> int:
    listed, faults = libraries.listed()
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    for library in listed:
        print(say(listing_text.listed(library, len(libraries.checkout(library).lacking()))))
    if not listed and not faults:
        print(say(Reason.of("cli.library_none")))
    return 1 if faults else 0


def _update(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    return _of_each(given.name, libraries, lambda library: _updated(library, libraries, is_agreed=given.agree))


def _updated(library: LockedLibrary, libraries: RemoteLibraries, *, is_agreed: bool) -> Reason:
    """Take over what is new in one library; why that is not done, where it is not."""
    renewal = libraries.renewal(library, _today())
    if isinstance(renewal, Reason):
        return renewal
    for line in listing_text.changed(library.name, renewal.changes):
        print(say(line))
    if renewal.changes.further and not is_agreed:
        if not sys.stdin.isatty():
            return Reason.of("cli.library_not_agreed", library=library.name)
        if not agrees(say(Reason.of("cli.library_agree_question"))):
            return Reason.of("cli.library_as_before", library=library.name)
    renewed = libraries.renew(library, renewal)
    return renewed.sentence if isinstance(renewed, Refusal) else NOTHING


def _fetch(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    return _of_each(given.name, libraries, lambda library: _fetched(library, libraries))


def _fetched(library: LockedLibrary, libraries: RemoteLibraries) -> Reason:
    """Have all of one library here; why that is not so, where it is not."""
    altered = libraries.checkout(library).altered()
    if altered:
        print(say(Reason.of("cli.library_altered", library=library.name, paths=altered)), file=sys.stderr)
    failed = libraries.fetch(library)
    if not failed:
        print(say(Reason.of("cli.library_fetched", library=library.name, count=len(library.files))))
    return failed


def _of_each(names: list[str], libraries: RemoteLibraries, do: Callable[[LockedLibrary], Reason]) -> int:
    """Do it with the libraries of these names, or with all; one that refuses does not keep others from it."""
    listed, faults = libraries.listed()
    code = 0
    for fault in faults:
        code = _no(fault.sentence)
    for name in names:
        if not any(library.name == name for library in listed):
            code = _no(Reason.of("store.library_unknown", library=name))
    for library in listed:
        if not names or library.name in names:
            failed = do(library)
            code = _no(Reason.of("cli.library_of", library=library.name, why=failed)) if failed else code
    return code


def _browse(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    library = libraries.find(given.address)
    offer = libraries.offer(library.address if library else given.address, _today())
    if isinstance(offer, Reason):
        return _no(offer)
    new = changes(library, offer.index) if library else None
    shown = contents(offer.index, frozenset((*new.added, *new.altered)) if new else frozenset())
    for line in listing_text.offered(offer):
        print(say(line))
    for entry in matching(shown, given.search):
        print(say(listing_text.entry(entry)))
    return 0


def _remove(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    refused = libraries.remove(given.name)
    return 0 if refused is None else _no(refused.sentence)


def _trust(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    library = libraries.find(given.name)
    if library is None:
        return _no(Reason.of("store.library_unknown", library=given.name))
    if not listing_text.is_fingerprint(given.signer):
        return _no(Reason.of("cli.library_no_fingerprint", text=given.signer))
    trusted = libraries.trust(library, given.signer, _who())
    return _no(trusted.sentence) if isinstance(trusted, Refusal) else 0


def _rights(given: argparse.Namespace, libraries: RemoteLibraries) -> int:
    library = libraries.find(given.name)
    if library is None:
        return _no(Reason.of("store.library_unknown", library=given.name))
    changed = libraries.give_rights(library, has_all_rights=given.rights == "all")
    if isinstance(changed, Refusal):
        return _no(changed.sentence)
    print(say(listing_text.rights(changed)))
    return 0


_ACTS: Mapping[str, Callable[[argparse.Namespace, RemoteLibraries], int]] = {
    "add": _add,
    "list": _list,
    "update": _update,
    "fetch": _fetch,
    "browse": _browse,
    "send": lambda given, libraries: sending.carry_out(given, libraries, _today()),
    "remove": _remove,
    "trust": _trust,
    "rights": _rights,
}


def _subscriber(parser: argparse.ArgumentParser) -> argparse.ArgumentParser:
    parser.add_argument("--local", type=directory, metavar="DIR", help=say(Reason.of("cli.library_local")))
    return parser


def _days(text: str) -> int:
    days = int(text)
    if not 1 <= days <= 3660:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.library_days_range")))
    return days


def _today() -> date:
    return datetime.now(UTC).date()


def _who() -> str:
    """Since when something is trusted, and by whom."""
    try:
        name = getpass.getuser()
    except (OSError, KeyError):
        name = ""
    return f"{_today().isoformat()} {name}".strip()


def _no(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 1
