"""What is believed of a signed index: only what its signer, its name, its version and its day permit (X16)."""

from dataclasses import dataclass
from datetime import date
from hashlib import sha256

import zstandard

from onika.files import library_index
from onika.files.library_index import LibraryIndex
from onika.files.library_lock import LockedLibrary
from onika.store.remote import signature as signatures
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class SignedIndex:
    """An index whose signature is good; who the signer is says his fingerprint, that he is trusted somebody else."""

    index: LibraryIndex
    signer: str
    digest: str
    """The SHA-256 of the signed bytes."""


def opened(content: bytes, program: str = signatures.PROGRAM) -> SignedIndex | Reason:
    """The index in signed bytes: nothing is unpacked before its signature is good, and never more than is allowed."""
    parted = signatures.parted(content)
    if isinstance(parted, Reason):
        return parted
    signature, body = parted
    fault = signatures.fault(signature, body, program)
    if fault:
        return fault
    return _read(content, signature.fingerprint, body)


def reopened(content: bytes, locked: LockedLibrary) -> SignedIndex | Reason:
    """The index that a lock names by its digest; whoever wrote the lock has judged its signature then."""
    parted = signatures.parted(content)
    if sha256(content).hexdigest() != locked.index or isinstance(parted, Reason):
        return Reason.of("store.index_altered", library=locked.name)
    return _read(content, locked.signer, parted[1])


def refusal(found: SignedIndex, locked: LockedLibrary, today: date) -> Reason:
    """Why an index is none that may follow the locked one; NOTHING where it may."""
    index = found.index
    trusted = {locked.signer, locked.next_key} - {""}
    if found.signer not in trusted:
        return Reason.of("store.signer_other", library=locked.name, signer=found.signer, trusted=locked.signer)
    if index.name != locked.name:
        return Reason.of("store.library_other", library=locked.name, found=index.name)
    if index.version < locked.version:
        return Reason.of("store.index_older", library=locked.name, version=index.version, seen=locked.version)
    if index.version == locked.version and found.digest != locked.index:
        return Reason.of("store.version_twice", library=locked.name, version=index.version)
    return overdue(index, today)


def overdue(index: LibraryIndex, today: date) -> Reason:
    """Why an index may not be taken for the newest any more; NOTHING where it may."""
    if index.until < today:
        return Reason.of("store.index_overdue", library=index.name, until=index.until.isoformat())
    return NOTHING


def _read(content: bytes, signer: str, body: bytes) -> SignedIndex | Reason:
    text = unpacked(body)
    if isinstance(text, Reason):
        return text
    index = library_index.read(text)
    if isinstance(index, Reason):
        return index
    return SignedIndex(index, signer, sha256(content).hexdigest())


def unpacked(body: bytes) -> bytes | Reason:
    """The text of an index; a reason where it is none, or more than is allowed."""
    most = library_index.LARGEST_TEXT
    try:
        with zstandard.ZstdDecompressor(max_window_size=2**27).stream_reader(body, read_across_frames=False) as stream:
            text = stream.read(most + 1)
    except (zstandard.ZstdError, MemoryError):
        return Reason.of("store.index_packed")
    return text if len(text) <= most else Reason.of("store.index_large", most=most)
