"""Own changes of a library's files written back to its site, where that permits it (requirement F03).

Nothing is overwritten that was not seen: where others have changed a file meanwhile, both changes are merged and shown;
where they contradict, nothing is sent, and both versions are kept beside each other.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from hashlib import sha256
from pathlib import Path

from msgspec import DecodeError, ValidationError, json

from onika.files.library_index import LARGEST_TEXT, LibraryIndex
from onika.files.library_lock import LockedLibrary
from onika.store.remote.object_cache import write_whole
from onika.store.remote.own_changes import OwnChange, conflict_folder
from onika.store.remote.proposal import Proposal, proposed
from onika.store.remote.remote_libraries import NewerVersion, RemoteLibraries
from onika.wire.library_change import ChangeAnswer, ChangedFile, ChangedMeanwhile, ChangeRefused, LibraryChange
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

_PATH = "changes"
_TRIES = 3
"""How often it is begun anew where others send something at the same time."""
_MODE = 0o644


@dataclass(frozen=True, slots=True)
class Sent:
    """It is in the library now, as this version; `merged` are files that hold what others have changed, too.

    behind      whether the library has more that is new, to which the user has to agree first
    """

    version: int
    paths: tuple[str, ...]
    merged: tuple[str, ...] = ()
    behind: bool = False


@dataclass(frozen=True, slots=True)
class Unsent:
    """Nothing was sent: these files contradict what others have changed, or nobody has looked at what was merged.

    folder      where all versions of them lie
    proposal    what would have been sent, and what contradicts it
    """

    folder: Path
    contradicting: tuple[str, ...]
    merged: tuple[str, ...]
    proposal: Proposal


@dataclass(frozen=True, slots=True)
class WriteBack:
    """For one library that is used.

    agrees      whether what was merged may be sent, and takes the place of the own files; the folder has it to look at
    keeps       told of an own file, before merged text takes its place, and what it holds; why not, where that fails
    """

    libraries: RemoteLibraries
    library: LockedLibrary
    agrees: Callable[[Proposal, Path], bool]
    keeps: Callable[[Path, str], Refusal | None]

    def send(
        self, changes: Sequence[OwnChange], today: date, note: str = "", *, mine_counts: bool = False
    ) -> Sent | Unsent | Reason:
        """Send these; why not, where that is not possible."""
        renewal = self.libraries.renewal(self.library, today)
        if isinstance(renewal, Reason):
            return renewal
        present = self._present(changes, renewal)
        for _ in range(_TRIES):
            if isinstance(present, Reason):
                return present
            proposal = proposed(changes, present, mine_counts=mine_counts)
            held = self._held(proposal, renewal.changes.version)
            if held is not None:
                return held
            answer = self._answer(proposal, note) if proposal.files else NOTHING
            if isinstance(answer, ChangedMeanwhile):
                present = {**present, **{file.path: file.content for file in answer.files if file.path in present}}
                continue
            if isinstance(answer, ChangeRefused):
                return answer.reason
            return answer if isinstance(answer, Reason) and answer else self._taken(proposal, today)
        return Reason.of("store.changes_cross", library=self.library.name)

    def _present(self, changes: Sequence[OwnChange], renewal: NewerVersion) -> Mapping[str, bytes | None] | Reason:
        """What the library has of these now."""
        index: LibraryIndex = renewal.offer.index
        files = [index.files[change.path] for change in changes if change.path in index.files]
        failed = self.libraries.access.bring(self.library.address, [file for file in files if file.content is None])
        if failed:
            return failed
        cache = self.libraries.access.cache
        now = {file.path: file.content if file.content is not None else cache.get(file.digest) for file in files}
        return {change.path: now.get(change.path) for change in changes}

    def _held(self, proposal: Proposal, version: int) -> Unsent | Reason | None:
        """Why it is not sent; None where it is, and then the own files are what is sent."""
        folder = conflict_folder(self.libraries.lock.base, self.library.name, version)
        try:
            self._laid_out(proposal, folder)
            merged = tuple(file.path for file in proposal.merged)
            if proposal.contradictions or (merged and not self.agrees(proposal, folder)):
                contradicting = tuple(conflict.path for conflict in proposal.contradictions)
                return Unsent(folder, contradicting, merged, proposal)
            return self._put_in_place(proposal)
        except OSError as error:
            return system_reason(error)

    def _laid_out(self, proposal: Proposal, folder: Path) -> None:
        """All versions of what was merged, or could not be; raises OSError."""
        for file in proposal.merged:
            write_whole(folder / f"{file.path}.merged", file.content, mode=_MODE)
            write_whole(folder / f"{file.path}.mine", file.own, mode=_MODE)
        for conflict in proposal.contradictions:
            versions = {"mine": conflict.mine, "theirs": conflict.theirs}
            versions |= {"before": conflict.before, "both": conflict.marked}
            for name, content in versions.items():
                if content is not None:
                    write_whole(folder / f"{conflict.path}.{name}", content, mode=_MODE)

    def _put_in_place(self, proposal: Proposal) -> Reason | None:
        for file in proposal.merged:
            own = self.libraries.lock.base / file.path
            if own.read_bytes() != file.own:
                return Reason.of("files.changed_since", path=str(own), who=NOTHING)
            refused = self.keeps(own, file.own.decode("utf-8"))
            if refused is not None:
                return refused.reason
            write_whole(own, file.content, mode=own.stat().st_mode & 0o777)
        return None

    def _answer(self, proposal: Proposal, note: str) -> ChangeAnswer | Reason:
        files = tuple(ChangedFile(file.path, file.base, file.content) for file in proposal.files)
        body = json.encode(LibraryChange(self.library.name, files, note))
        answer = self.libraries.access.sent(self.library.address, _PATH, body, LARGEST_TEXT)
        if isinstance(answer, Reason):
            return answer
        try:
            taken: ChangeAnswer = json.decode(answer, type=ChangeAnswer)
        except (DecodeError, ValidationError, RecursionError):
            return Reason.of("store.no_change_answer", address=self.library.address)
        return taken

    def _taken(self, proposal: Proposal, today: date) -> Sent | Reason:
        """Go on from what the library has now: what was sent is where the own files begin."""
        paths, merged = (tuple(file.path for file in files) for files in (proposal.files, proposal.merged))
        there = (*proposal.files, *proposal.same)
        begun = {file.path: sha256(file.content).hexdigest() for file in there}
        library = self.libraries.begun_with(self.library, begun, [file.content for file in there])
        if isinstance(library, Refusal):
            return library.reason
        renewal = self.libraries.renewal(library, today)
        if isinstance(renewal, Reason) or renewal.changes.further:
            version = library.version if isinstance(renewal, Reason) else renewal.changes.version
            return Sent(version, paths, merged, behind=True)
        renewed = self.libraries.renew(library, renewal)
        if isinstance(renewed, Refusal):
            return renewed.reason
        return Sent(renewed.version, paths, merged)
