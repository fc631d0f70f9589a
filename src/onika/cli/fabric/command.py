"""The acts of `onika fabric`: a router, a site's card, files of cards, and what all places together know (F06)."""

import argparse
import os
import sys
import threading
from collections.abc import Callable, Mapping
from datetime import UTC, date, datetime, timedelta
from pathlib import Path

from onika.cli.fabric import listing_text
from onika.cli.language import say
from onika.fabric.card import OfferedRuntime, VisitingCard
from onika.fabric.phone_book import BOOK, PhoneBook
from onika.fabric.signed_card import SignedCard, bound, opened, signed
from onika.fabric.zenoh_program import PORT, announce, route
from onika.files.state.state_directory import state_directory
from onika.store.remote.object_cache import write_whole
from onika.store.remote.publication import DAYS, fingerprint_of
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason_with_place

_MODE = 0o644
_MOST_DAYS = 366


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_fabric")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    _describe_routing(acts)
    card = acts.add_parser("card", help=say(Reason.of("cli.fabric_card")))
    card.add_argument("name", metavar="NAME", help=say(Reason.of("cli.fabric_name")))
    card.add_argument("--key", type=Path, required=True, metavar="KEY", help=say(Reason.of("cli.fabric_key")))
    card.add_argument("--to", type=Path, required=True, metavar="FILE", help=say(Reason.of("cli.fabric_to")))
    card.add_argument("--desc", default="", metavar="TEXT", help=say(Reason.of("cli.fabric_desc")))
    runtime = say(Reason.of("cli.fabric_runtime"))
    card.add_argument("--runtime", action="append", default=[], metavar="URL[=ROBOT,…]", help=runtime)
    library = say(Reason.of("cli.fabric_library"))
    card.add_argument("--library", action="append", default=[], metavar="URL", help=library)
    card.add_argument("--days", type=int, default=DAYS, metavar="N", help=say(Reason.of("cli.fabric_days")))
    card.add_argument("--next-key", type=Path, metavar="KEY.pub", help=say(Reason.of("cli.fabric_next_key")))
    book = acts.add_parser("book", help=say(Reason.of("cli.fabric_book")))
    book.add_argument("cards", type=Path, nargs="+", metavar="CARD")
    book.add_argument("--to", type=Path, required=True, metavar="FOLDER", help=say(Reason.of("cli.fabric_book_to")))
    acts.add_parser("list", help=say(Reason.of("cli.fabric_list")))
    acts.add_parser("add", help=say(Reason.of("cli.fabric_add"))).add_argument("place", metavar="PLACE")
    acts.add_parser("remove", help=say(Reason.of("cli.fabric_remove"))).add_argument("place", metavar="PLACE")
    trust = acts.add_parser("trust", help=say(Reason.of("cli.fabric_trust")))
    trust.add_argument("name", metavar="NAME")
    trust.add_argument("signer", metavar="SHA256:…")


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 0 where it could be done, 1 where something was refused."""
    why = _ACTS[given.act](given)
    if why:
        print(say(why), file=sys.stderr)
    return 1 if why else 0


def _describe_routing(acts: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    router = acts.add_parser("router", help=say(Reason.of("cli.fabric_router")))
    listen = say(Reason.of("cli.fabric_listen"))
    router.add_argument("--listen", action="append", default=[], metavar="tcp/HOST:PORT", help=listen)
    peer = say(Reason.of("cli.fabric_peer"))
    router.add_argument("--peer", action="append", default=[], metavar="tcp/HOST:PORT", help=peer)
    announcing = acts.add_parser("announce", help=say(Reason.of("cli.fabric_announce")))
    announcing.add_argument("cards", type=Path, nargs="+", metavar="CARD")
    announcing.add_argument("--at", default="", metavar="tcp/HOST:PORT", help=say(Reason.of("cli.fabric_at")))
    for parser in (router, announcing):
        parser.add_argument("--config", type=Path, metavar="FILE", help=say(Reason.of("cli.fabric_config")))


def _router(given: argparse.Namespace) -> Reason:
    listen = given.listen or [f"tcp/127.0.0.1:{PORT}"]
    begun = Reason.of("cli.fabric_listening", places=", ".join(listen))
    return _spoken(lambda until, ready: route(listen, given.peer, given.config, until, ready), begun)


def _announce(given: argparse.Namespace) -> Reason:
    try:
        cards = [path.read_bytes() for path in given.cards]
    except OSError as error:
        return system_reason_with_place(error)
    for content in cards:
        seen = opened(content)
        if isinstance(seen, Reason):
            return seen
    begun = Reason.of("cli.fabric_announcing", count=len(cards))
    return _spoken(lambda until, ready: announce(cards, given.at, given.config, until, ready), begun)


def _spoken(speak: Callable[[threading.Event, Callable[[], None]], None], begun: Reason) -> Reason:
    """Speak Zenoh until Ctrl-C; why it could not begin."""
    until = threading.Event()
    try:
        speak(until, lambda: print(say(begun), flush=True))
    except ImportError:
        return Reason.of("fabric.no_zenoh")
    except OSError as wrong:
        return Reason.of("cli.fabric_not_opened", why=Reason.plain(str(wrong)))
    except KeyboardInterrupt:
        return NOTHING
    return NOTHING


def _card(given: argparse.Namespace) -> Reason:
    next_key = ""
    now = datetime.now(UTC)
    try:
        if given.next_key is not None:
            next_key = fingerprint_of(given.next_key) or ""
            if not next_key:
                return Reason.of("cli.library_no_key", path=str(given.next_key))
        until = now.date() + timedelta(days=max(1, min(given.days, _MOST_DAYS)))
        runtimes = tuple(map(_runtime, given.runtime))
        serial = max(int(now.timestamp()), _former(given.to, given.name) + 1)
        card = VisitingCard(given.name, serial, until, given.desc, runtimes, tuple(given.library), next_key)
        content = signed(card, given.key)
        seen = content if isinstance(content, Reason) else opened(content)
        if isinstance(seen, Reason) or isinstance(content, Reason):
            return seen if isinstance(seen, Reason) else NOTHING
        write_whole(given.to.absolute(), content, _MODE)
    except OSError as error:
        return system_reason_with_place(error)
    path, last = str(given.to), until.isoformat()
    print(say(Reason.of("cli.fabric_carded", path=path, name=card.name, size=len(content), until=last)))
    print(say(Reason.of("cli.fabric_signed", signer=seen.signer)))
    return NOTHING


def _former(path: Path, name: str) -> int:
    """The serial of the card that stands there, which a newer one exceeds, however the clock was set meanwhile."""
    try:
        seen = opened(path.read_bytes())
    except FileNotFoundError:
        return 0
    if isinstance(seen, SignedCard) and seen.card.name == name:
        return seen.card.serial
    return 0


def _runtime(text: str) -> OfferedRuntime:
    address, _, robots = text.partition("=")
    return OfferedRuntime(address, tuple(filter(None, robots.split(","))))


def _book(given: argparse.Namespace) -> Reason:
    try:
        contents = [path.read_bytes() for path in given.cards]
        for content in contents:
            seen = opened(content)
            if isinstance(seen, Reason):
                return seen
        whole = bound(contents)
        write_whole(given.to.absolute() / BOOK, whole, _MODE)
    except OSError as error:
        return system_reason_with_place(error)
    path = str(given.to / BOOK)
    print(say(Reason.of("cli.fabric_bound", path=path, count=len(contents), size=len(whole))))
    return NOTHING


def _list(_: argparse.Namespace) -> Reason:
    look = _phone_book().look(_today())
    if isinstance(look, Reason):
        return look
    for line in listing_text.lines(look):
        print(say(line))
    return NOTHING


def _add(given: argparse.Namespace) -> Reason:
    return _phone_book().add_place(given.place) or NOTHING


def _remove(given: argparse.Namespace) -> Reason:
    return _phone_book().drop_place(given.place) or NOTHING


def _trust(given: argparse.Namespace) -> Reason:
    return _phone_book().trust(given.name, given.signer) or NOTHING


def _phone_book() -> PhoneBook:
    return PhoneBook(state_directory(os.environ))


def _today() -> date:
    return datetime.now(UTC).date()


_ACTS: Mapping[str, Callable[[argparse.Namespace], Reason]] = {
    "router": _router,
    "announce": _announce,
    "card": _card,
    "book": _book,
    "list": _list,
    "add": _add,
    "remove": _remove,
    "trust": _trust,
}
