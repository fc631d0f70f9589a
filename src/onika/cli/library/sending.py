"""`onika library send`: write own changes of a library's files back to its site (requirement F03)."""

import argparse
import os
import sys
import time
from collections.abc import Iterator
from datetime import date
from pathlib import Path

from onika.cli.language import say
from onika.cli.lines.consent import agrees
from onika.files.state.state_directory import state_directory
from onika.store.remote.own_changes import named_changes, own_changes
from onika.store.remote.proposal import Proposal
from onika.store.remote.remote_libraries import RemoteLibraries
from onika.store.remote.write_back import Sent, Unsent, WriteBack
from onika.store.replaced_texts import ReplacedTexts
from onika.words.reason import Reason


def describe(parser: argparse.ArgumentParser) -> None:
    """What it takes."""
    parser.add_argument("name", metavar="NAME")
    parser.add_argument("paths", nargs="*", metavar="PATH", help=say(Reason.of("cli.library_send_paths")))
    parser.add_argument("--note", default="", metavar="TEXT", help=say(Reason.of("cli.library_send_note")))
    parser.add_argument("--agree", action="store_true", help=say(Reason.of("cli.library_send_agree")))
    parser.add_argument("--mine", action="store_true", help=say(Reason.of("cli.library_send_mine")))


def carry_out(given: argparse.Namespace, libraries: RemoteLibraries, today: date) -> int:
    """Send; 0 where the library has it now, 1 where nothing was sent."""
    library = libraries.find(given.name)
    if library is None:
        return _no(Reason.of("store.library_unknown", library=given.name))
    checkout = libraries.checkout(library)
    changes = named_changes(checkout, given.paths) if given.paths else own_changes(checkout)
    if isinstance(changes, Reason):
        return _no(changes)
    if not changes:
        return _no(Reason.of("cli.library_send_nothing", library=library.name, path=str(libraries.lock.base)))
    replaced = ReplacedTexts(state_directory(os.environ))
    writing = WriteBack(
        libraries,
        library,
        lambda proposal, folder: _agrees(proposal, folder, is_agreed=given.agree),
        lambda path, text: replaced.keep(path, text, time.time()),
    )
    done = writing.send(changes, today, given.note, mine_counts=given.mine)
    if isinstance(done, Reason):
        return _no(Reason.of("cli.library_of", library=library.name, why=done))
    for line in _told(done, library.name):
        print(say(line), file=sys.stderr if isinstance(done, Unsent) else sys.stdout)
    return 1 if isinstance(done, Unsent) else 0


def _agrees(proposal: Proposal, folder: Path, *, is_agreed: bool) -> bool:
    """Whether what was merged is sent: said with the command, or at a terminal."""
    if is_agreed or not sys.stdin.isatty():
        return is_agreed
    paths = tuple(file.path for file in proposal.merged)
    return agrees(say(Reason.of("cli.library_send_question", paths=paths, folder=str(folder))))


def _told(done: Sent | Unsent, library: str) -> Iterator[Reason]:
    """What has become of it."""
    if isinstance(done, Unsent):
        if done.contradicting:
            paths, folder = done.contradicting, str(done.folder)
            yield Reason.of("cli.library_contradicting", library=library, paths=paths, folder=folder)
        else:
            yield Reason.of("cli.library_merged_unseen", library=library, paths=done.merged, folder=str(done.folder))
        return
    yield Reason.of("cli.library_sent", library=library, version=done.version, paths=done.paths)
    if done.merged:
        yield Reason.of("cli.library_sent_merged", paths=done.merged)
    if done.behind:
        yield Reason.of("cli.library_behind", library=library)


def _no(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 1
