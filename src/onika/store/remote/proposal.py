"""What would be sent to a library: own changes, merged with what others have changed there meanwhile (F03)."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from hashlib import sha256

from onika.store.remote.own_changes import OwnChange
from onika.store.remote.three_way import merged


@dataclass(frozen=True, slots=True)
class ProposedFile:
    """A file as it would be.

    base    the SHA-256 of what it takes the place of; empty: of nothing
    own     what the user's own file holds
    """

    path: str
    base: str
    content: bytes
    own: bytes

    @property
    def is_merged(self) -> bool:
        """Whether it holds what others have changed, too."""
        return self.content != self.own


@dataclass(frozen=True, slots=True)
class Contradiction:
    """A file that both sides have changed, and not so that both could be kept in one.

    theirs  what the library has; None: they have removed it
    marked  both in one text, between marks; None where it is no text
    """

    path: str
    mine: bytes
    theirs: bytes | None
    before: bytes | None
    marked: bytes | None


@dataclass(frozen=True, slots=True)
class Proposal:
    """What would be sent, and what stands in its way; `same` is what the library has already."""

    files: tuple[ProposedFile, ...] = ()
    contradictions: tuple[Contradiction, ...] = ()
    same: tuple[ProposedFile, ...] = ()

    @property
    def merged(self) -> tuple[ProposedFile, ...]:
        """What nobody has looked at yet."""
        return tuple(file for file in self.files if file.is_merged)


def proposed(
    changes: Iterable[OwnChange], present: Mapping[str, bytes | None], *, mine_counts: bool = False
) -> Proposal:
    """What follows from own changes and what the library has now, by paths.

    mine_counts     where both contradict, the own one takes the place of theirs: the user has said so
    """
    files, contradictions, same = list[ProposedFile](), list[Contradiction](), list[ProposedFile]()
    for change in changes:
        theirs = present[change.path]
        if theirs == change.content:
            same.append(ProposedFile(change.path, _hash(theirs), change.content, change.content))
            continue
        found = _merged(change, theirs)
        if isinstance(found, Contradiction) and not mine_counts:
            contradictions.append(found)
            continue
        content = change.content if isinstance(found, Contradiction) else found
        files.append(ProposedFile(change.path, _hash(theirs), content, change.content))
    return Proposal(tuple(files), tuple(contradictions), tuple(same))


def _merged(change: OwnChange, theirs: bytes | None) -> bytes | Contradiction:
    if _hash(theirs) == change.base:
        return change.content
    texts = [_text(content) for content in (change.before, change.content, theirs)]
    before, mine, others = texts
    if before is None or mine is None or others is None:
        return Contradiction(change.path, change.content, theirs, change.before, None)
    both = merged(before, mine, others)
    content = both.text.encode()
    if both.conflicts:
        return Contradiction(change.path, change.content, theirs, change.before, content)
    return content


def _text(content: bytes | None) -> str | None:
    try:
        return None if content is None else content.decode("utf-8")
    except UnicodeDecodeError:
        return None


def _hash(content: bytes | None) -> str:
    return "" if content is None else sha256(content).hexdigest()
