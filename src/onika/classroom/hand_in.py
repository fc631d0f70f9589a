"""What a learner hands in: his own base directory, and what is open in it whether it is saved or not (X25).

The seat puts it together in a folder of its own; the class takes it over from there, plain files only, and of each no
more than fits: a link leads nowhere.
"""

import os
import stat
from collections.abc import Iterator
from pathlib import Path

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.files import appl, conf
from onika.files.state.state_directory import make_own
from onika.words.name import TASK_NAME
from onika.words.reason import NOTHING, Reason

MOST_FILES = 2000
MOST_BYTES = 32 * 1024 * 1024
_DEEPEST = 6
_OPEN = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC


def open_texts(model: Model) -> dict[str, str]:
    """What is open, by the path that it has in a hand-in."""
    texts: dict[str, str] = {}
    for file in model.open_files:
        if not TASK_NAME.match(file.name) or len(texts) >= MOST_FILES:
            continue
        if isinstance(file, OpenApplication):
            texts[f"appl/{file.name}{appl.ENDING}"] = appl.write(file.application)
        elif isinstance(file, Document) and file.is_dirty:
            texts[f"conf/{file.name}{conf.ENDING}"] = conf.write(file.content.configuration)
    return texts


def put_together(own: Path, texts: dict[str, str], folder: Path) -> Reason:
    """Make the folder, which must not be there, of a base directory and of texts that take the place of its files.

    Why it is not whole, if so; raises OSError.
    """
    why = taken_over(own, folder) if own.is_dir() else NOTHING
    for name, content in texts.items():
        path = folder / name
        make_own(path.parent)
        path.unlink(missing_ok=True)
        path.write_text(content, encoding="utf-8")
    make_own(folder)
    return why


def taken_over(source: Path, target: Path) -> Reason:
    """Copy plain files into a new folder; why not all, if so. Raises OSError."""
    make_own(target)
    left, files = MOST_BYTES, 0
    for place, name, folder in _plain_files(source):
        descriptor = _opened(name, folder)
        if descriptor is None:
            continue
        with os.fdopen(descriptor, "rb") as file:
            content = file.read(left + 1)
        left, files = left - len(content), files + 1
        if left < 0 or files > MOST_FILES:
            return Reason.of("class.hand_in_large", files=MOST_FILES, megabytes=MOST_BYTES >> 20)
        make_own(target / place)
        with os.fdopen(os.open(target / place / name, _NEW, 0o600), "wb") as copy:
            copy.write(content)
    return NOTHING


def _plain_files(source: Path) -> Iterator[tuple[str, str, int]]:
    """Each with the folder it lies in, as a path below `source` and as a descriptor that is open for the moment."""
    for place, folders, names, folder in os.fwalk(source, follow_symlinks=False):
        inner = os.path.relpath(place, source)
        if inner.count(os.sep) >= _DEEPEST:
            folders.clear()
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(names):
            yield inner, name, folder


def _opened(name: str, folder: int) -> int | None:
    """A descriptor of a plain file; None where it is none, or cannot be read."""
    try:
        descriptor = os.open(name, _OPEN, dir_fd=folder)
    except OSError:
        return None
    if stat.S_ISREG(os.fstat(descriptor).st_mode):
        return descriptor
    os.close(descriptor)
    return None
