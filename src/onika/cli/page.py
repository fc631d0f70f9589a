"""`onika`: open the environment in a browser, with a runtime of its own; what `onika` alone does."""

import argparse
import asyncio
import os
import sys
import webbrowser
from pathlib import Path

from onika.cli.runtime import add_base, unit
from onika.cli.search_path import site_here
from onika.link.token import read_token
from onika.web.program import EnvironmentProgram, Wishes
from onika.web.server import bound

PORT = 8420
_HEAD = "Onika is open at"
_NEXT = "for another browser:"


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument(
        "files", nargs="*", metavar="FILE", help="configurations and applications to open, by name or file"
    )
    parser.add_argument(
        "--port", type=int, metavar="N", help=f"the port on this machine ({PORT}, else any that is free)"
    )
    parser.add_argument("--no-browser", action="store_true", help="only print the address")
    parser.add_argument(
        "--connect", metavar="URL", help="a runtime that runs already, in place of one of its own: ws://HOST:PORT"
    )
    parser.add_argument("--token-file", type=Path, metavar="FILE", help="the token of that runtime")
    parser.add_argument("--no-connect", action="store_true", help="no runtime: only look and edit")
    parser.add_argument(
        "--rtpu", action="append", default=[], type=unit, metavar="NAME",
        help="a processing unit of its own runtime; may be given several times (rt0)",
    )  # fmt: skip
    parser.add_argument("--no-fifo", action="store_true", help="do not ask for real-time scheduling")
    parser.add_argument("--upper", action="store_true", help="only the upper level: applications, no tasks")
    parser.add_argument("--no-diary", action="store_true", help="keep no log of what is done")
    add_base(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Open the environment, until Ctrl-C."""
    if given.connect and given.no_connect:
        given.complain("expected --connect or --no-connect, found both")
    try:
        listening = bound(PORT if given.port is None else given.port)
    except OSError as taken:
        if given.port is not None:
            given.complain(f"expected a port that is free, found {given.port}: {taken.strerror}")
        listening = bound(0)
    token = "" if given.token_file is None else read_token(given.token_file)
    wishes = Wishes(
        files=tuple(given.files),
        url=given.connect or "",
        token=token,
        is_connected=not given.no_connect,
        rtpus=tuple(dict.fromkeys(given.rtpu)) or ("rt0",),
        with_fifo=not given.no_fifo,
        has_diary=not given.no_diary,
        is_upper_only=given.upper,
    )
    program = EnvironmentProgram(site_here(given.base), wishes, state_directory())
    shows = not given.no_browser and _has_screen()
    answers: list[str] = []

    def tell(address: str) -> None:
        _tell(address, shows, is_first=not answers)
        answers.append(address)

    asyncio.run(program.run(listening, tell))
    return 0


def state_directory() -> Path:
    """Where diary and recovery are kept (XDG)."""
    named = os.environ.get("XDG_STATE_HOME")
    return (Path(named) if named else Path.home() / ".local" / "state") / "onika"


def _has_screen() -> bool:
    return sys.platform == "darwin" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _tell(address: str, shows: bool, is_first: bool) -> None:
    print(f"{_HEAD if is_first else _NEXT} {address}", flush=True)
    if is_first:
        print("The address lets one browser in; then the next one is printed. Ctrl-C ends.", flush=True)
    if shows and is_first:
        webbrowser.open(address)
