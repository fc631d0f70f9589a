"""The text of a file: its bytes as UTF-8, with faults where they are not (requirement B07)."""

from pathlib import Path

from onika.words.fault import Fault, Place


def load(path: Path, file: str) -> tuple[str | None, tuple[Fault, ...]]:
    """The text at a path, line ends as they are; None with the fault where it cannot be read. `file` names it."""
    try:
        data = path.read_bytes()
    except OSError as error:
        reason = error.strerror or type(error).__name__
        return None, (Fault(Place(file), "a file that can be read", reason, "the file is left out"),)
    return decode(data, file)


def decode(data: bytes, file: str) -> tuple[str | None, tuple[Fault, ...]]:
    """These bytes as text; None with a fault that names the line of the first byte that is no UTF-8."""
    try:
        return data.decode("utf-8"), ()
    except UnicodeDecodeError as error:
        place = Place(file, data.count(b"\n", 0, error.start) + 1)
        found = f"the byte 0x{data[error.start]:02x}"
        return None, (Fault(place, "text in UTF-8", found, "the file is left out"),)
