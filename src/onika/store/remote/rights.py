"""What code of a library of others may do here: compute and nothing else, or all that its user may (X16).

The lock says which. Beside the folder in which such a library stands there is a word of it, so that whoever has a file
knows without the lock.
"""

from contextlib import suppress
from pathlib import Path

from onika.store.remote.checkout_path import checked_out_folder
from onika.store.remote.object_cache import write_whole

_ENDING = ".all-rights"


def is_confined(path: Path) -> bool:
    """Whether the code of a file may compute, and nothing else."""
    folder = checked_out_folder(path)
    return folder is not None and not _word(folder).is_file()


def put_word(folder: Path, *, has_all_rights: bool) -> None:
    """Have the word beside the folder of a library, or not; raises OSError."""
    if has_all_rights:
        write_whole(_word(folder), b"", is_lasting=False)
    else:
        with suppress(FileNotFoundError):
            _word(folder).unlink()


def _word(folder: Path) -> Path:
    return folder.with_name(folder.name + _ENDING)
