"""All files of a library that do not stand in its index, in one: who wants many of them asks once (F03)."""

from collections.abc import Mapping
from hashlib import sha256

import zstandard

from onika.files.library_index import LARGEST_TEXT, IndexedFile, LibraryIndex

_LEVEL = 19


def packed(files: Mapping[str, bytes]) -> bytes:
    """The pack of these, by their paths; empty where there are none, or too much for one."""
    whole = b"".join(files[path] for path in sorted(files))
    if not files or len(whole) > LARGEST_TEXT:
        return b""
    return zstandard.ZstdCompressor(level=_LEVEL).compress(whole)


def unpacked(content: bytes, index: LibraryIndex) -> Mapping[str, bytes]:
    """What a pack holds, by SHA-256; nothing where it is not the pack of this index, or not what its files should be.

    Whoever gets nothing asks for the files one by one.
    """
    files = packed_files(index)
    size = sum(file.size for file in files)
    if sha256(content).hexdigest() != index.pack or size > LARGEST_TEXT:
        return {}
    try:
        with zstandard.ZstdDecompressor(max_window_size=2**27).stream_reader(content) as stream:
            whole = stream.read(size + 1)
    except (zstandard.ZstdError, MemoryError):
        return {}
    if len(whole) != size:
        return {}
    contents, at = {}, 0
    for file in files:
        part = whole[at : at + file.size]
        at += file.size
        if sha256(part).hexdigest() == file.digest:
            contents[file.digest] = part
    return contents


def packed_files(index: LibraryIndex) -> tuple[IndexedFile, ...]:
    """The files of a pack, in its order."""
    return tuple(index.files[path] for path in sorted(index.files) if index.files[path].content is None)
