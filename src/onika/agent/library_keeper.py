"""The library of a site, into which changed files are taken: judged, written all or none, published anew (F03, X16).

Nothing is written over what its sender has not seen: each file comes with the hash of what it was begun with.
"""

import threading
from collections import deque
from collections.abc import Callable, Mapping
from datetime import date
from hashlib import sha256

from onika.agent.change_check import ChangeCheck
from onika.agent.file_set import FileSet
from onika.agent.launches import Guest
from onika.link.caller import Role
from onika.store.audit_trail import AuditTrail
from onika.store.remote.publication import Publication, Publisher
from onika.wire.library_change import (
    ChangeAnswer,
    ChangedFile,
    ChangedMeanwhile,
    ChangeRefused,
    ChangeTaken,
    LibraryChange,
    PresentFile,
)
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

MOST_FILES = 100
"""Files of one change."""
MOST_BYTES = 12_000_000
"""Bytes of all of them, and of what is answered."""
MOST_CHANGES = 20
"""Changes of one user within a minute."""
_MINUTE_NS = 60 * 1_000_000_000
_LONGEST_NOTE = 300
_NAMED = 20
"""Files of a change that are named in the trail."""


class LibraryKeeper:
    """One base directory and the folder into which it is published; any thread may send changes.

    trail   each change that is taken or refused has a line there
    today   the day; an index is good from then on
    clock   ns that never go back
    """

    def __init__(
        self,
        publisher: Publisher,
        check: ChangeCheck,
        trail: AuditTrail,
        today: Callable[[], date],
        clock: Callable[[], int],
    ) -> None:
        self.publisher = publisher
        self._check = check
        self._trail = trail
        self._today = today
        self._clock = clock
        self._files = FileSet(publisher.base)
        self._lock = threading.Lock()
        self._times: dict[str, deque[int]] = {}

    def begin(self) -> Publication | Reason | None:
        """Complete what was under way, and publish what is not published yet; None where nothing was to be done."""
        try:
            self._files.complete()
        except OSError as error:
            return system_reason(error)
        if self.publisher.is_published(self._today()):
            return None
        return self._published()

    def take(self, change: LibraryChange, guest: Guest) -> ChangeAnswer:
        """Have the files of the library be so, and publish it."""
        with self._lock:
            answer = self._answer(change, guest)
        self._note(change, guest, answer)
        return answer

    def _answer(self, change: LibraryChange, guest: Guest) -> ChangeAnswer:
        why_not = self._refusal(change, guest)
        if why_not:
            return ChangeRefused(why_not)
        try:
            former = {file.path: self._present(file.path) for file in change.files}
            other = [path for path, file in zip(former, change.files, strict=True) if _hash(former[path]) != file.base]
            if other:
                return ChangedMeanwhile(_as_far_as_allowed({path: former[path] for path in other}))
            return self._replaced(change, former)
        except OSError as error:
            return ChangeRefused(Reason.of("site.library_not_written", why=system_reason(error)))

    def _replaced(self, change: LibraryChange, former: Mapping[str, bytes | None]) -> ChangeAnswer:
        self._files.replace({file.path: file.content for file in change.files})
        published = self._published()
        if isinstance(published, Reason):
            self._files.replace(former)
            return ChangeRefused(Reason.of("site.library_not_published", why=published))
        return ChangeTaken(published.index.name, published.index.version)

    def _published(self) -> Publication | Reason:
        former = self.publisher.former()
        if isinstance(former, Reason):
            return former
        description, next_key = (former.description, former.next_key) if former else ("", "")
        if next_key and next_key == self._signer():
            next_key = ""  # it is the key by now
        return self.publisher.publish(self._today(), description=description, next_key=next_key)

    def _signer(self) -> str | None:
        try:
            return self.publisher.signer
        except OSError:
            return None

    def _refusal(self, change: LibraryChange, guest: Guest) -> Reason:
        """Why nothing of it is done, whatever is there now."""
        name = self.publisher.name
        if guest.role < Role.PROGRAMMER:
            return Reason.of("site.programmer_wanted", role=guest.role.word, user=guest.name)
        if not self._is_in_time(guest.name):
            return Reason.of("site.changes_too_fast", most=MOST_CHANGES)
        if change.library != name:
            return Reason.of("site.library_other", library=name)
        paths = [file.path for file in change.files]
        if not paths or len(paths) > MOST_FILES or len(set(paths)) < len(paths):
            return Reason.of("site.change_files", most=MOST_FILES)
        size = sum(len(file.content) for file in change.files)
        if size > MOST_BYTES:
            return Reason.of("site.change_large", size=size, most=MOST_BYTES)
        return next(filter(None, map(self._file_refusal, change.files)), NOTHING)

    def _file_refusal(self, file: ChangedFile) -> Reason:
        refusal = self._check.refusal(file.path, file.content)
        if refusal:
            return refusal
        target = self.publisher.base / file.path
        places = [target, *target.parents[: file.path.count("/")]]
        if any(place.is_symlink() for place in places) or target.is_dir():
            return Reason.of("site.file_elsewhere", path=file.path)
        if any(place.exists() and not place.is_dir() for place in places[1:]):
            return Reason.of("site.file_elsewhere", path=file.path)
        return NOTHING

    def _is_in_time(self, user: str) -> bool:
        times, now_ns = self._times.setdefault(user, deque(maxlen=MOST_CHANGES)), self._clock()
        if len(times) == MOST_CHANGES and now_ns - times[0] < _MINUTE_NS:
            return False
        times.append(now_ns)
        return True

    def _present(self, path: str) -> bytes | None:
        try:
            return (self.publisher.base / path).read_bytes()
        except FileNotFoundError:
            return None

    def _note(self, change: LibraryChange, guest: Guest, answer: ChangeAnswer) -> None:
        files = " ".join(f"{file.path}@{sha256(file.content).hexdigest()[:16]}" for file in change.files[:_NAMED])
        match answer:
            case ChangeTaken(version=version):
                result = f"version {version}"
            case ChangedMeanwhile(files=present):
                result = f"behind {' '.join(file.path for file in present[:_NAMED])}"
            case ChangeRefused(reason=reason):
                result = f"refused:{reason}"
        self._trail.note(
            "ChangeLibrary",
            isinstance(answer, ChangeTaken),
            who=guest.name,
            role=guest.role.word,
            on=self.publisher.name,
            about=f"{files} {change.note[:_LONGEST_NOTE]}".strip(),
            result=result,
        )


def _hash(content: bytes | None) -> str:
    return "" if content is None else sha256(content).hexdigest()


def _as_far_as_allowed(contents: Mapping[str, bytes | None]) -> tuple[PresentFile, ...]:
    """At least one of them, and no more than an answer may have."""
    files: list[PresentFile] = []
    size = 0
    for path, content in contents.items():
        size += len(content or b"")
        if files and size > MOST_BYTES:
            break
        files.append(PresentFile(path, content))
    return tuple(files)
