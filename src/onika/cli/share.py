"""`onika share`: a recorded run as one HTML file that plays in any browser, without network and without Onika."""

import argparse
import os
import sys
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.environment.lone_review import read_alone
from onika.desk.environment.shared.sharing import MOST_BYTES, SharedFile, shared_file
from onika.files.state.state_directory import state_directory
from onika.store.mesh_folder import MeshFolder
from onika.web.app import PLAYER
from onika.words.reason import Reason

_MB = 1_000_000
_LIMIT_MB = MOST_BYTES / _MB


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_share")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", type=Path, metavar="RUN.mcap")
    parser.add_argument("-o", dest="out", type=Path, metavar="OUT.html", help=say(Reason.of("cli.share_out")))
    parser.add_argument("--overwrite", action="store_true", help=say(Reason.of("cli.text_overwrite")))
    parser.add_argument("--limit", type=_megabytes, default=_LIMIT_MB, metavar="MB", help=say(_limit_help()))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Write the file; 2 where the recording cannot be read, or the file not be written."""
    out = given.out or Path(f"{given.file.stem}.html")
    if out.exists() and not given.overwrite:
        return _failed(Reason.of("cli.share_there", path=str(out)))
    site = site_here(given.local)
    reading = read_alone(given.file, site)
    if isinstance(reading, Reason):
        return _failed(reading)
    folder = MeshFolder(state_directory(os.environ))
    shared = shared_file(reading.subject, reading.tree, site, PLAYER, round(given.limit * _MB), folder)
    reading.subject.review.close()
    if isinstance(shared, Reason):
        return _failed(shared)
    try:
        out.write_text(shared.text, encoding="utf-8")
    except OSError as wrong:
        return _failed(Reason.of("record.of_file", path=str(out), why=Reason.plain((wrong.strerror or "").lower())))
    for note in _notes(shared, given.limit):
        print(say(Reason.of("cli.note", text=note)), file=sys.stderr)
    print(say(Reason.of("cli.share_written", path=str(out), size=len(shared.text.encode()) / _MB)))
    return 0


def _notes(shared: SharedFile, limit: float) -> list[Reason]:
    """What whoever sends the file should know."""
    notes = list(shared.notes)
    if shared.is_coarse:
        notes.append(Reason.of("cli.share_coarse", seconds=shared.period_s))
    if not shared.fits:
        notes.append(Reason.of("cli.share_large", limit=limit))
    return notes


def _failed(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 2


def _limit_help() -> Reason:
    return Reason.of("cli.share_limit", limit=_LIMIT_MB)


def _megabytes(text: str) -> float:
    try:
        size = float(text)
    except ValueError:
        size = 0.0
    if not 0.0 < size <= 1e4:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.share_size", text=text)))
    return size
