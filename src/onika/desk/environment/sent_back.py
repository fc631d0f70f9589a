"""Acts that write own changes back to a library of others: shown first, and never over what was not seen (F03)."""

from collections.abc import Callable, Iterable
from datetime import UTC, datetime
from functools import partial
from hashlib import sha256
from pathlib import Path

from onika.desk.environment.outcome.outcome import Done, No, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.refresh import refreshed
from onika.desk.environment.state.model import Model
from onika.store.remote.address import WebAddress, library_address
from onika.store.remote.credential import Credential
from onika.store.remote.library_access import PASSWORD_REASONS
from onika.store.remote.own_changes import OwnChange, named_changes, own_changes
from onika.store.remote.proposal import Proposal
from onika.store.remote.remote_libraries import RemoteLibraries
from onika.store.remote.write_back import Sent, WriteBack
from onika.store.replaced_texts import ReplacedTexts
from onika.wire import act
from onika.wire.view import HeldFileView, OwnChangeView, SentBackView
from onika.words.fault import Refusal
from onika.words.reason import Reason

_NOT_HERE = No(Reason.of("desk.no_remote_libraries"))
_LONGEST = 200_000
"""Bytes of a text that is shown."""

Keeps = Callable[[Path, str], Refusal | None]


def list_own_changes(model: Model, command: act.ListOwnChanges, outside: Services) -> Procedure:
    """What own copies change in a library; the value is a tuple of `view.OwnChangeView`."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    model, views = yield Work(model, services.worker, partial(_listed, services.libraries, command.library))
    return No(views) if isinstance(views, Reason) else Done(model, value=views)


def send_back(model: Model, command: act.SendBack, outside: Services) -> Procedure:
    """Send them, or show what stands in the way; the value is a `view.SentBackView`."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    libraries = services.libraries
    sending = partial(_sent, libraries, command, outside.calendar(), _keeps(outside))
    model, sent = yield Work(model, services.worker, sending)
    if isinstance(sent, Reason):
        return No(sent, fields={"secret": sent} if sent.key in PASSWORD_REASONS else {})
    library = libraries.find(command.library)
    if not sent.version or library is None:
        return Done(model, value=sent)
    folder = libraries.checkout(library).folder
    theirs = (path for path in folder.rglob("*") if path.is_file())
    done = refreshed(model, frozenset((*theirs, *(libraries.lock.base / path for path in sent.merged))), outside.site)
    return Done(done.model, value=sent, says=done.says)


def _listed(libraries: RemoteLibraries, name: str) -> tuple[OwnChangeView, ...] | Reason:
    library = libraries.find(name)
    if library is None:
        return Reason.of("store.library_unknown", library=name)
    return tuple(map(_change, own_changes(libraries.checkout(library))))


def _sent(libraries: RemoteLibraries, command: act.SendBack, now_s: float, keeps: Keeps) -> SentBackView | Reason:
    library = libraries.find(command.library)
    if library is None:
        return Reason.of("store.library_unknown", library=command.library)
    changes = named_changes(libraries.checkout(library), command.paths)
    if isinstance(changes, Reason):
        return changes
    place = library_address(library.address)
    if isinstance(place, WebAddress) and command.secret:
        libraries.access.let_in(place, Credential(command.secret, command.user))
    writing = WriteBack(libraries, library, lambda proposal, _: _agreement(proposal) == command.agreed, keeps)
    done = writing.send(changes, datetime.fromtimestamp(now_s, UTC).date(), command.note, mine_counts=command.is_mine)
    libraries.access.hang_up()
    if isinstance(done, Reason):
        return done
    if isinstance(done, Sent):
        return SentBackView(library.name, done.version, done.paths, done.merged, done.behind)
    held = tuple(_held(done.proposal))
    agreement = "" if done.contradicting else _agreement(done.proposal)
    return SentBackView(library.name, held=held, agreement=agreement, folder=str(done.folder))


def _keeps(outside: Services) -> Keeps:
    """What keeps an own file before merged text takes its place."""

    def keep(path: Path, text: str) -> Refusal | None:
        if outside.state is None:
            return Refusal(Reason.of("desk.nowhere_to_keep", path=str(path)))
        return ReplacedTexts(outside.state).keep(path, text, outside.calendar())

    return keep


def _agreement(proposal: Proposal) -> str:
    """Names just what was merged."""
    digest = sha256()
    for file in proposal.merged:
        for part in (file.path.encode(), file.content):
            digest.update(len(part).to_bytes(8, "big") + part)
    return digest.hexdigest()


def _held(proposal: Proposal) -> Iterable[HeldFileView]:
    for conflict in proposal.contradictions:
        (mine, other), is_text = _shown(conflict.mine, conflict.theirs or b"")
        yield HeldFileView(conflict.path, mine, other, contradicts=True, is_text=is_text)
    for file in proposal.merged:
        (mine, other), is_text = _shown(file.own, file.content)
        yield HeldFileView(file.path, mine, other, is_text=is_text)


def _change(change: OwnChange) -> OwnChangeView:
    (before, mine), is_text = _shown(change.before or b"", change.content)
    return OwnChangeView(change.path, before, mine, is_text)


def _shown(*contents: bytes) -> tuple[list[str], bool]:
    """As texts, and whether they are some that can be shown."""
    try:
        if max(map(len, contents)) <= _LONGEST:
            return [content.decode("utf-8") for content in contents], True
    except UnicodeDecodeError:
        pass
    return ["" for _ in contents], False
