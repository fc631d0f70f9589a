"""`onika study replay`: a session is rebuilt from its log, in the page or at once (requirement H08)."""

import argparse
import asyncio
import sys
import tempfile
import time
import webbrowser
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import learn, say
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.replay import replay_place
from onika.desk.environment.replay.replay_control import ReplayControl
from onika.desk.environment.replay.session_player import SessionPlayer
from onika.files import text
from onika.files.state import session_log
from onika.files.state.session_log import LogLine
from onika.web.replay_program import ReplayProgram
from onika.web.server import bound
from onika.wire import act
from onika.words.fault import Fault
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("replay.purpose")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("log", nargs="+", type=Path, metavar="FILE", help=say(Reason.of("replay.option_file")))
    parser.add_argument(
        "--base", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("replay.option_base"))
    )
    parser.add_argument("--to", type=Path, metavar="DIR", help=say(Reason.of("replay.option_to")))
    parser.add_argument("--no-page", action="store_true", help=say(Reason.of("replay.option_no_page")))
    parser.add_argument("--speed", type=float, default=1.0, metavar="N", help=say(Reason.of("replay.option_speed")))
    parser.add_argument("--port", type=int, default=0, metavar="N", help=say(Reason.of("replay.option_port")))
    parser.add_argument("--no-browser", action="store_true", help=say(Reason.of("cli.page_no_browser")))


def carry_out(given: argparse.Namespace) -> int:
    """Replay it; 1 where something could not be done as it was, 2 where nothing can be replayed. Raises OSError."""
    lines, faults = _lines(given.log)
    if not any(line.record for line in lines):
        return _failed([*(fault.sentence for fault in faults), Reason.of("replay.no_start", path=str(given.log[0]))])
    if given.to is not None and given.to.exists() and any(given.to.iterdir()):
        return _failed([Reason.of("replay.not_empty", path=str(given.to))])
    with ExitStack() as stack:
        folder = given.to or Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="onika-replay-")))
        place = replay_place.made(lines, [Path(base) for base in given.base], folder, given.log[0].name)
        learn(place.site.directories)
        if given.no_page:
            player = SessionPlayer(lines, place, HANDLERS, given.log[0].name)
            player.faults[:0] = faults
            while player.step() is not None:
                pass
        else:
            player = _shown(given, lines, place, faults)
    return _told(player, given.to)


def _lines(paths: Sequence[Path]) -> tuple[tuple[LogLine, ...], list[Fault]]:
    """The lines of a log, whose parts may stand in several files; faults name the lines of the first."""
    faults: list[Fault] = []
    parts = []
    for path in paths:
        content, wrong = text.load_bytes(path, str(path))
        part, torn = text.decode_foreign(content or b"", str(path))
        faults += (*wrong, *torn)
        parts.append(part)
    lines, wrong = session_log.read("\n".join(part.rstrip("\n") for part in parts), paths[0].name)
    return lines, [*faults, *wrong]


def _shown(
    given: argparse.Namespace, lines: Sequence[LogLine], place: replay_place.ReplayPlace, faults: Sequence[Fault]
) -> SessionPlayer:
    """Replay it in the page, until Ctrl-C."""
    control = ReplayControl(time.monotonic, given.log[0].name, given.speed, is_playing=False)  # until somebody looks
    player = SessionPlayer(lines, place, {**HANDLERS, act.SteerReplay: control.steer}, given.log[0].name)
    player.faults[:0] = faults
    addresses: list[str] = []

    def tell(address: str) -> None:
        key = "cli.page_next" if addresses else "cli.page_open"
        print(say(Reason.of(key, address=address)), flush=True)
        if not addresses and not given.no_browser:
            webbrowser.open(address)
        addresses.append(address)

    try:
        asyncio.run(ReplayProgram(player, control).run(bound(given.port), tell))
    except KeyboardInterrupt:
        return player
    return player


def _told(player: SessionPlayer, to: Path | None) -> int:
    """Say what came of it."""
    wrong = [fault for fault in player.faults if not fault.is_note]
    for fault in player.faults:
        print(say(fault.sentence), file=sys.stderr)
    done, count = player.position, len(player.lines)
    print(say(Reason.of("replay.replayed", done=done, count=count, faults=len(wrong))))
    if to is not None:
        print(say(Reason.of("replay.kept_at", path=str(to))))
    return int(bool(wrong))


def _failed(reasons: Sequence[Reason]) -> int:
    for reason in reasons:
        print(say(reason), file=sys.stderr)
    return 2
