"""`onika`: open the environment in a browser, with a runtime of its own; what `onika` alone does."""

import argparse
import asyncio
import os
import signal
import socket
import sys
import webbrowser
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from onika.cli.language import say
from onika.cli.runtime import add_base, unit
from onika.cli.search_path import add_dictionaries, chosen_dictionaries, site_here
from onika.desk.environment.state.settings import PRESENTATIONS
from onika.files.state.state_directory import state_directory
from onika.link.starting.runtime_address import address_of
from onika.link.token import read_token
from onika.store.mesh_folder import MeshFolder
from onika.web.access.certificate import fingerprint
from onika.web.access.page_place import PageOptions, PagePlace, judged
from onika.web.environment_options import EnvironmentOptions
from onika.web.page_front import PageFront
from onika.web.page_window import PageWindow
from onika.web.server import bound
from onika.words.fault import Fault
from onika.words.name import TASK_NAME
from onika.words.reason import NOTHING, Reason, reason_of
from onika.words.system_error import system_reason

if TYPE_CHECKING:  # what is to be loaded later
    from onika.desk.environment.environment import Environment
    from onika.web.hub import Hub
    from onika.web.program import EnvironmentProgram

PORT = 8420
PROFILE = "browser"
"""What the browser of a window keeps, below the state directory."""


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_page")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("files", nargs="*", metavar="FILE", help=say(Reason.of("cli.page_files")))
    parser.add_argument("--port", type=int, metavar="N", help=say(Reason.of("cli.page_port", port=PORT)))
    parser.add_argument("--no-browser", action="store_true", help=say(Reason.of("cli.page_no_browser")))
    parser.add_argument("--window", type=window, metavar="SIZE", help=say(Reason.of("cli.page_window")))
    parser.add_argument("--ends-with-window", action="store_true", help=say(Reason.of("cli.page_ends_with_window")))
    parser.add_argument("--connect", metavar="URL", help=say(Reason.of("cli.page_connect")))
    parser.add_argument(
        "--at", action="append", default=[], type=station, metavar="NAME=URL",
        help=say(Reason.of("cli.page_at")),
    )  # fmt: skip
    parser.add_argument(
        "--token-file", action="append", default=[], type=token_file, metavar="[NAME=]FILE",
        help=say(Reason.of("cli.page_token_file")),
    )  # fmt: skip
    parser.add_argument("--listen", metavar="HOST[:PORT]", help=say(Reason.of("cli.page_listen")))
    parser.add_argument("--cert", metavar="FILE", help=say(Reason.of("cli.page_cert")))
    parser.add_argument("--key", metavar="FILE", help=say(Reason.of("cli.runtime_key")))
    parser.add_argument("--users", metavar="FILE", help=say(Reason.of("cli.page_users")))
    parser.add_argument("--name", action="append", default=[], metavar="HOST", help=say(Reason.of("cli.runtime_name")))
    parser.add_argument("--no-connect", action="store_true", help=say(Reason.of("cli.page_no_connect")))
    parser.add_argument(
        "--rtpu", action="append", default=[], type=unit, metavar="NAME",
        help=say(Reason.of("cli.page_rtpu")),
    )  # fmt: skip
    parser.add_argument("--no-fifo", action="store_true", help=say(Reason.of("cli.page_no_fifo")))
    parser.add_argument("--no-black-box", action="store_true", help=say(Reason.of("cli.no_black_box")))
    parser.add_argument("--upper", action="store_true", help=say(Reason.of("cli.page_upper")))
    add_dictionaries(parser)
    presented = say(Reason.of("cli.page_presentation"))
    parser.add_argument("--presentation", choices=PRESENTATIONS, default="", help=presented)
    parser.add_argument("--no-forecast", action="store_true", help=say(Reason.of("cli.page_no_forecast")))
    parser.add_argument("--no-diary", action="store_true", help=say(Reason.of("cli.page_no_diary")))
    add_base(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Open the environment, until Ctrl-C."""
    tokens = dict(given.token_file)
    if contradiction := _contradiction(given, tokens):
        given.complain(say(contradiction))
    place, faults = _place(given)
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    if faults:
        return 2
    site = site_here(given.base)
    dictionaries = chosen_dictionaries(site, given.dictionary)
    if isinstance(dictionaries, Reason):
        print(say(dictionaries), file=sys.stderr)
        return 2
    listening = _listening(given, place)
    options = EnvironmentOptions(
        files=tuple(given.files),
        url=given.connect or "",
        token=tokens.get("", ""),
        stations=tuple((name, url, tokens.get(name, "")) for name, url in given.at),
        is_connected=not given.no_connect,
        rtpus=tuple(dict.fromkeys(given.rtpu)) or ("rt0",),
        with_fifo=not given.no_fifo,
        has_black_box=not given.no_black_box,
        foresees=not given.no_forecast,
        has_diary=not given.no_diary,
        is_upper_only=given.upper,
        dictionaries=dictionaries,
        presentation=given.presentation,
    )
    state = state_directory(os.environ)
    shows = not given.no_browser and has_screen()
    answers: list[str] = []

    def tell(address: str) -> None:
        _tell(address, shows, given.window, state / PROFILE, closed, is_first=not answers)
        answers.append(address)

    def closed() -> None:
        _closed(has_come=len(answers) > 1, ends=given.ends_with_window)

    def program() -> "EnvironmentProgram":
        from onika.web.program import EnvironmentProgram  # two thirds of the time to a page are spent on loading it

        return EnvironmentProgram(site, options, state)

    if place is None:
        asyncio.run(PageFront(listening, tell, state).run(program))
    else:
        _serve_others(program(), place, listening, MeshFolder(state))
    return 0


def _serve_others(
    program: "EnvironmentProgram", place: PagePlace, listening: socket.socket, meshes: MeshFolder
) -> None:
    """Serve the page to users who sign in."""
    from onika.web.guarded_door import GuardedDoor
    from onika.web.served_door import ServedDoor

    def opens(environment: "Environment", hub: "Hub") -> ServedDoor:
        door = GuardedDoor(place, listening, partial(_tell_others, place), environment, hub)
        return ServedDoor(door, hub, listening, meshes)

    asyncio.run(program.run(opens))


def _contradiction(given: argparse.Namespace, tokens: Mapping[str, str]) -> Reason:
    """What cannot be wanted together; nothing: all can."""
    if given.connect and given.no_connect:
        return Reason.of("cli.connect_or_not")
    if given.ends_with_window and given.window is None:
        return Reason.of("cli.window_that_ends")
    names = [name for name, _ in given.at]
    strange = next((name for name in (*names, *tokens) if name and names.count(name) != 1), "")
    return Reason.of("cli.station_once", name=strange) if strange else NOTHING


def _tell_others(place: PagePlace, address: str) -> None:
    print(say(Reason.of("cli.page_served", address=address)), flush=True)
    print(say(Reason.of("cli.page_fingerprint", fingerprint=fingerprint(place.certificate))), flush=True)


def _place(given: argparse.Namespace) -> tuple[PagePlace | None, list[Fault]]:
    """Where the page is served to others, where that is asked for, and what is missing for it."""
    if given.listen:
        if given.port is not None:
            given.complain(say(Reason.of("cli.listen_or_port")))
        wanted = PageOptions(given.listen, given.cert or "", given.key or "", given.users or "", tuple(given.name))
        return judged(wanted, PORT)
    named = {"--cert": given.cert, "--key": given.key, "--users": given.users, "--name": given.name}
    without = next((option for option, value in named.items() if value), None)
    if without is not None:
        given.complain(say(Reason.of("cli.listen_expected", option=without)))
    return None, []


def _listening(given: argparse.Namespace, place: PagePlace | None) -> socket.socket:
    """The port: that which is asked for, else the usual one or any that is free."""
    if place is not None:
        try:
            return bound(place.port, place.host)
        except OSError as wrong:
            given.complain(say(Reason.of("cli.not_listening", listen=given.listen, why=system_reason(wrong))))
    try:
        return bound(PORT if given.port is None else given.port)
    except OSError as taken:
        if given.port is not None:
            given.complain(say(Reason.of("cli.port_taken", port=given.port, why=system_reason(taken))))
        return bound(0)


def station(text: str) -> tuple[str, str]:
    """A station and the address of its runtime, as a word of a command line."""
    from onika.desk.environment.reconcile.station_names import HERE  # with it the model of the environment

    name, equals, url = text.partition("=")
    try:
        if not equals or not TASK_NAME.match(name) or name == HERE:
            raise ValueError(Reason.of("cli.station_expected", text=text))
        return name, str(address_of(url))
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def window(text: str) -> PageWindow:
    """The window of the page, as a word of a command line."""
    try:
        return PageWindow.read(text)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def token_file(text: str) -> tuple[str, str]:
    """A station, empty for the first one, and the token of its runtime, which stands in a file."""
    name, equals, path = text.rpartition("=")
    try:
        return (name, read_token(Path(path))) if equals else ("", read_token(Path(text)))
    except (OSError, ValueError) as wrong:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.token_expected", reason=reason_of(wrong)))) from None


def has_screen() -> bool:
    """Whether there is a screen on which a browser could be opened."""
    return sys.platform == "darwin" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _closed(*, has_come: bool, ends: bool) -> None:
    """The window of the page was closed: it ends, as by Ctrl-C, unless its browser never came to the page."""
    if not ends:
        return
    if not has_come:
        print(say(Reason.of("cli.window_never_came")), flush=True)
        return
    print(say(Reason.of("cli.window_closed")), flush=True)
    os.kill(os.getpid(), signal.SIGINT)


def _tell(
    address: str, shows: bool, wanted: PageWindow | None, profile: Path, closed: Callable[[], None], *, is_first: bool
) -> None:
    if not is_first:
        print(say(Reason.of("cli.page_next", address=address)), flush=True)
        return
    print(say(Reason.of("cli.page_open", address=address)), flush=True)
    print(say(Reason.of("cli.page_key")), flush=True)
    if wanted is not None and not (shows and wanted.open(address, profile, closed)):
        said = Reason.of(
            "cli.window_by_hand", width=wanted.width, height=wanted.height, left=wanted.left, top=wanted.top
        )
        print(say(said), flush=True)
    if shows and (wanted is None or not wanted.command(address, profile)):
        webbrowser.open(address)
