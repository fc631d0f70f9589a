"""`onika class`: a workcell for each learner on this machine, and a board of all for the teacher (requirement X25)."""

import argparse
import os
import signal
import sys
import webbrowser
from pathlib import Path

from onika.classroom.grading import Grading
from onika.classroom.program import LOOPBACK, ClassOptions, ClassProgram
from onika.classroom.seat_program import SeatSettings
from onika.cli.argument_kinds import directory, expectation_of
from onika.cli.language import learn, say
from onika.cli.page import PORT as PAGE_PORT, has_screen
from onika.files.state.state_directory import state_directory
from onika.process import confinement
from onika.store.base_directory import BaseDirectory
from onika.web.access.page_place import PageOptions, PagePlace, judged
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of

PORT = PAGE_PORT + 10
MOST_SEATS = 60
_MEMORY_MB = 1500


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_class")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("files", nargs="*", metavar="FILE", help=say(Reason.of("cli.class_files")))
    parser.add_argument("--seats", type=_seats, default=20, metavar="N", help=say(Reason.of("cli.class_seats")))
    parser.add_argument("--name", type=_name, default="class", metavar="NAME", help=say(Reason.of("cli.class_name")))
    parser.add_argument("--folder", type=Path, metavar="DIR", help=say(Reason.of("cli.class_folder")))
    parser.add_argument(
        "--expect", action="append", default=[], type=expectation_of, metavar="'LAMP == 1'",
        help=say(Reason.of("cli.class_expect")),
    )  # fmt: skip
    parser.add_argument(
        "--test", action="append", default=[], type=_test, metavar="FILE.test", help=say(Reason.of("cli.class_test"))
    )
    parser.add_argument("--port", type=int, metavar="N", help=say(Reason.of("cli.class_port", port=PORT)))
    parser.add_argument("--listen", metavar="HOST[:PORT]", help=say(Reason.of("cli.class_listen")))
    parser.add_argument("--cert", metavar="FILE", help=say(Reason.of("cli.page_cert")))
    parser.add_argument("--key", metavar="FILE", help=say(Reason.of("cli.runtime_key")))
    parser.add_argument(
        "--host-name", action="append", default=[], metavar="HOST", help=say(Reason.of("cli.runtime_name"))
    )
    parser.add_argument(
        "--base", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.class_base"))
    )
    parser.add_argument(
        "--memory", type=_megabytes, default=_MEMORY_MB, metavar="MB",
        help=say(Reason.of("cli.class_memory", most=_MEMORY_MB)),
    )  # fmt: skip
    parser.add_argument("--code", action="store_true", help=say(Reason.of("cli.class_code")))
    parser.add_argument("--unconfined", action="store_true", help=say(Reason.of("cli.class_unconfined")))
    parser.add_argument("--upper", action="store_true", help=say(Reason.of("cli.page_upper")))
    parser.add_argument("--no-browser", action="store_true", help=say(Reason.of("cli.page_no_browser")))


def carry_out(given: argparse.Namespace) -> int:
    """Keep a class, until Ctrl-C."""
    is_confined = confinement.level() > 0
    if not is_confined and not given.unconfined:
        print(say(Reason.of("cli.class_not_confined")), file=sys.stderr)
        return 2
    place, is_wrong = _place(given)
    if is_wrong:
        return 2
    options = _options(given, place, is_confined=is_confined and not given.unconfined)
    learn([BaseDirectory(path) for path in options.seat.materials])
    try:
        program = ClassProgram(options)
    except (OSError, ValueError) as wrong:
        print(say(Reason.of("cli.class_not_begun", why=reason_of(wrong))), file=sys.stderr)
        return 2
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    shows = not given.no_browser and has_screen()
    addresses: list[str] = []

    def tell(address: str, code: str, board: str) -> None:
        if not addresses:
            print(say(Reason.of("cli.class_open", address=address, code=code)), flush=True)
            if shows:
                webbrowser.open(board)
        print(say(Reason.of("cli.class_board", address=board)), flush=True)
        addresses.append(board)

    program.run(tell)
    return 0


def _place(given: argparse.Namespace) -> tuple[PagePlace | None, bool]:
    """Where it is for others, where that is asked for; whether something is missing for it, which is said."""
    named = {"--cert": given.cert, "--key": given.key, "--host-name": given.host_name}
    if not given.listen:
        without = next((option for option, value in named.items() if value), None)
        if without is not None:
            given.complain(say(Reason.of("cli.listen_expected", option=without)))
        return None, False
    if given.port is not None:
        given.complain(say(Reason.of("cli.listen_or_port")))
    wanted = PageOptions(given.listen, given.cert or "", given.key or "", "", tuple(given.host_name))
    place, faults = judged(wanted, PORT, needs_users=False)
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    return place, place is None


def _options(given: argparse.Namespace, place: PagePlace | None, *, is_confined: bool) -> ClassOptions:
    folder = (given.folder or state_directory(os.environ) / "classes" / given.name).absolute()
    materials = tuple(Path(base).absolute() for base in given.base)
    programs = [Path(name).stem for name in given.files if not name.endswith(".conf")]
    seat = SeatSettings(
        0,
        "",
        folder / "seats",
        LOOPBACK if place is None else place.names,
        tuple(given.files),
        materials,
        "" if place is None else str(Path(place.certificate).absolute()),
        "" if place is None else str(Path(given.key).absolute()),
        is_confined,
        given.code,
        given.upper,
    )
    grading = Grading(
        tuple(condition.text for condition in given.expect),
        tuple(given.test),
        programs[0] if programs else "",
        materials,
        is_confined,
    )
    port = PORT if given.port is None else given.port
    host, context = (LOOPBACK[0], None) if place is None else (place.host, place.context)
    port = port if place is None else place.port
    return ClassOptions(folder, given.seats, seat, grading, host, port, given.memory << 20, context)


def _seats(text: str) -> int:
    return _whole(text, 1, MOST_SEATS)


def _megabytes(text: str) -> int:
    return _whole(text, 300, 1_000_000)


def _whole(text: str, least: int, most: int) -> int:
    if not text.isdecimal() or len(text) > 9 or not least <= int(text) <= most:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.between_expected", least=least, most=most, text=text)))
    return int(text)


def _name(text: str) -> str:
    if not TASK_NAME.match(text):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.site_name_expected", text=text)))
    return text


def _test(text: str) -> Path:
    path = Path(text)
    if not path.is_file():
        raise argparse.ArgumentTypeError(say(Reason.of("cli.file_expected", text=text)))
    return path.absolute()
