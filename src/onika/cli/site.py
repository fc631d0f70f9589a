"""`onika site`: let others launch what is listed, and look at, launch or end what is at another site (A15, F06)."""

import argparse
import os
import socket
import sys
from pathlib import Path

from onika.booking.book import book_path
from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.lines import site_text
from onika.cli.lines.consent import agrees
from onika.desk.run.remote_runtime import token_for
from onika.files import text
from onika.files.site import launch_list
from onika.files.state.access import STRANGERS, WRITING, Access, guard
from onika.files.state.kept_certificates import keep_certificate
from onika.files.state.known_sites import KnownSites, known_sites_path
from onika.files.state.state_directory import state_directory
from onika.link.address import PORT as RUNTIME_PORT, bracketed, split_host
from onika.link.lost import LinkLost
from onika.link.shown_certificate import fingerprint_of, shown_certificate, unfit
from onika.link.starting.site_address import PORT, SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.link.token import read_token
from onika.model.launch import Launch
from onika.process.orderly_exit import in_order
from onika.store.remote.publication import Publisher
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of

_PORTS = {"wss": RUNTIME_PORT, "https": 443}


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_site")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    serve = acts.add_parser("serve", help=say(Reason.of("cli.site_serve")))
    serve.add_argument("list", type=Path, metavar="FILE", help=say(Reason.of("cli.site_list")))
    serve.add_argument("--name", type=_name, metavar="NAME", help=say(Reason.of("cli.site_name")))
    serve.add_argument(
        "--listen", default=f"127.0.0.1:{PORT}", metavar="HOST:PORT", help=say(Reason.of("cli.site_listen", port=PORT))
    )
    serve.add_argument("--cert", default="", metavar="FILE", help=say(Reason.of("cli.runtime_cert")))
    serve.add_argument("--key", default="", metavar="FILE", help=say(Reason.of("cli.runtime_key")))
    serve.add_argument("--users", default="", metavar="FILE", help=say(Reason.of("cli.runtime_users")))
    serve.add_argument(
        "--host-name", action="append", default=[], metavar="HOST", help=say(Reason.of("cli.runtime_name"))
    )
    serve.add_argument("--book", type=Path, metavar="FILE", help=say(Reason.of("cli.runtime_book")))
    serve.add_argument("--library", type=directory, metavar="DIR", help=say(Reason.of("cli.site_library")))
    serve.add_argument("--library-to", type=Path, metavar="FOLDER", help=say(Reason.of("cli.site_library_to")))
    serve.add_argument("--library-key", type=Path, metavar="KEY", help=say(Reason.of("cli.site_library_key")))
    serve.add_argument("--library-name", type=_name, metavar="NAME", help=say(Reason.of("cli.library_name")))
    serve.add_argument("--no-fifo", action="store_true", help=say(Reason.of("cli.page_no_fifo")))
    serve.add_argument("--no-black-box", action="store_true", help=say(Reason.of("cli.no_black_box")))
    trust = acts.add_parser("trust", help=say(Reason.of("cli.site_trust")))
    trust.add_argument("place", type=_place, metavar="HOST[:PORT]")
    trust.add_argument("--sha256", default="", metavar="XX:…", help=say(Reason.of("cli.site_trust_option")))
    _elsewhere(acts.add_parser("card", help=say(Reason.of("cli.site_card"))))
    _elsewhere(acts.add_parser("launch", help=say(Reason.of("cli.site_launch"))))
    _elsewhere(acts.add_parser("end", help=say(Reason.of("cli.site_end"))))
    acts.add_parser("known", help=say(Reason.of("cli.site_known")))
    forget = acts.add_parser("forget", help=say(Reason.of("cli.site_forget")))
    forget.add_argument("name", metavar="NAME")


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 0 where it could be done, 1 where it was refused, 2 where something is missing."""
    match given.act:
        case "serve":
            return _serve(given)
        case "known":
            for line in site_text.listed(KnownSites(known_sites_path()).all()):
                print(say(line))
            return 0
        case "forget":
            return _forget(given.name)
    try:
        return _trust(given.place[0], given.place[1], given.sha256) if given.act == "trust" else _at_another(given)
    except LinkLost as lost:
        return _no(lost.reason)


def _trust(host: str, port: int, named: str) -> int:
    """Keep the certificate that is shown there, where the user says that it is the right one."""
    certificate = shown_certificate(host, port)
    fingerprint = fingerprint_of(certificate)
    print(say(Reason.of("cli.site_certificate", place=f"{bracketed(host)}:{port}", fingerprint=fingerprint)))
    wrong = unfit(host, port, certificate)
    if wrong is not None:
        return _no(wrong)
    if named or not sys.stdin.isatty():
        is_right = named.replace(":", "").upper() == fingerprint.replace(":", "")
    else:
        is_right = agrees(say(Reason.of("cli.site_trust_question", host=host)))
    if not is_right:
        return _no(Reason.of("cli.site_not_trusted", fingerprint=fingerprint))
    try:
        path = keep_certificate(host, certificate)
    except OSError as wrong_here:
        return _no(reason_of(wrong_here))
    print(say(Reason.of("cli.site_trusted", host=host, path=str(path))))
    return 0


def _elsewhere(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("address", type=_address, metavar="site://HOST[:PORT]/NAME")
    parser.add_argument("--token-file", type=Path, metavar="FILE", help=say(Reason.of("cli.site_token_file")))
    parser.add_argument("--ca", type=Path, metavar="FILE", help=say(Reason.of("cli.run_ca")))


def _serve(given: argparse.Namespace) -> int:
    from onika.agent.program import SiteOptions, SiteProgram
    from onika.host.sessions.listen_options import ListenOptions, judge  # within: only who serves needs all that

    launches = _listed(given.list)
    named = ((given.users, WRITING), (given.cert, WRITING), (given.key, STRANGERS), (given.list, WRITING))
    report = guard(Access(Path(path), denied) for path, denied in named if path)
    for sentence in report.sentences:
        print(say(sentence), file=sys.stderr)
    if launches is None or report.refused:
        return 2
    listen = _with_port(given.listen)
    settings, faults, token_at = judge(
        ListenOptions(listen, given.cert, given.key, given.users, tuple(given.host_name))
    )
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    if settings is None:
        return 2
    book = given.book if given.book is not None else book_path(os.environ)
    name = given.name or _own_name()
    state = state_directory(os.environ)
    if given.library and given.library_key is None:
        return _no(Reason.of("cli.site_library_needs_key"), 2)
    library = _library(given, state) if given.library else None
    options = SiteOptions(name, launches, given.users, book, not given.no_fifo, not given.no_black_box, library)
    try:
        program = SiteProgram(options, settings, state)
    except OSError as wrong:
        return _no(reason_of(wrong), 2)
    with in_order():
        program.run(lambda place: _tell(name, place, token_at, _library_lines(library, place, settings.certificate)))
    return 0


def _library(given: argparse.Namespace, state: Path) -> Publisher:
    """What the site publishes of its own; where no folder is named, only the site itself gives it away."""
    base = Path(given.library).absolute()
    name = given.library_name or base.name
    folder = given.library_to or state / "published" / name
    return Publisher(base, folder.absolute(), given.library_key, name)


def _library_lines(library: Publisher | None, place: str, certificate: str) -> list[Reason]:
    """Where others find the library of the site, and the key with which they compare."""
    if library is None:
        return []
    address = f"{'https' if certificate else 'http'}://{place}/library"
    signed = Reason.of("cli.library_signer", signer=library.signer) if library.signer else None
    return [line for line in (Reason.of("cli.site_library_at", library=library.name, address=address), signed) if line]


def _tell(name: str, place: str, token_at: str, library_lines: list[Reason]) -> None:
    """One write, so that whoever waits for the first line reads it whole."""
    token = Reason.of("cli.site_token_at", path=token_at) if token_at else Reason.plain("")
    lines = [Reason.of("cli.site_serves", name=name, place=place, token=token), *library_lines]
    sys.stdout.write("".join(f"{say(line)}\n" for line in lines))
    sys.stdout.flush()


def _at_another(given: argparse.Namespace) -> int:
    address: SiteAddress = given.address
    try:
        token = token_for(address) if given.token_file is None else read_token(given.token_file)
    except (OSError, ValueError) as wrong:
        return _no(Reason.of("cli.token_expected", reason=reason_of(wrong)), 2)
    client = SiteClient(address, token, given.ca)
    card = client.card()
    known = KnownSites(known_sites_path()).all().get(card.site)
    is_another = known is not None and known.identity != card.identity
    if given.act == "card":
        for line in site_text.card(card):
            print(say(line))
    elif not address.name:
        return _no(Reason.of("cli.site_which", names=tuple(launch.name for launch in card.launches)), 2)
    if known is not None and is_another:
        return _no(Reason.of("link.site_twice", site=card.site, place=known.place, here=address.place))
    if given.act == "card":
        return 0
    if given.act == "end":
        client.end()
        print(say(Reason.of("cli.site_ended", name=address.name)))
        return 0
    handed = client.launch()
    print(say(site_text.launched(handed, str(address.runtime(handed.port)))))
    return 0


def _forget(name: str) -> int:
    if KnownSites(known_sites_path()).forget(name):
        return 0
    return _no(Reason.of("cli.site_not_known", name=name))


def _listed(path: Path) -> tuple[Launch, ...] | None:
    content, faults = text.load(path, str(path))
    launches = None
    if content is not None:
        launches, faults = launch_list.read(content, path.name, str(path))
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    return launches


def _with_port(place: str) -> str:
    """With the usual port of a site, where none is named."""
    try:
        _, port = split_host(place)
    except ValueError:
        return place
    return place if port is not None else f"{place}:{PORT}"


def _own_name() -> str:
    name = socket.gethostname().partition(".")[0]
    return name if TASK_NAME.match(name) else "site"


def _name(given: str) -> str:
    if not TASK_NAME.match(given):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.site_name_expected", text=given)))
    return given


def _place(given: str) -> tuple[str, int]:
    """Host and port, also of an address of Onika's or of the web."""
    scheme, _, rest = given.rpartition("://")
    try:
        host, port = split_host(rest.partition("/")[0])
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None
    return host, port if port is not None else _PORTS.get(scheme, PORT)


def _address(given: str) -> SiteAddress:
    try:
        return SiteAddress.parse(given)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def _no(reason: Reason, code: int = 1) -> int:
    print(say(reason), file=sys.stderr)
    return code
