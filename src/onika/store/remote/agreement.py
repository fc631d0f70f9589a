"""What the tasks of a library say that they write and touch, and what of it nobody has agreed to (X16)."""

from collections.abc import Mapping

from onika.files import rmod
from onika.files.library_index import LibraryIndex
from onika.files.library_lock import Agreement

_DEVICE = "DEVICE"
_NOTHING = Agreement()


def declared(index: LibraryIndex) -> Mapping[str, Agreement]:
    """By tasks: the state variables that their files let them write, and their devices.

    A task whose file is at fault is no task; it says nothing.
    """
    agreements = {}
    for path, file in index.files.items():
        if path.startswith("module/") and path.endswith(rmod.ENDING) and file.content is not None:
            name = path.removeprefix("module/").removesuffix(rmod.ENDING)
            agreement = agreement_of(name, file.content)
            if agreement is not None:
                agreements[name] = agreement
    return agreements


def agreement_of(name: str, content: bytes) -> Agreement | None:
    """What the file of a task says; None where it cannot be read."""
    try:
        record, _ = rmod.read(content.decode("utf-8"), name, name)
    except UnicodeDecodeError:
        return None
    if record is None:
        return None
    devices = (line.words[0] for line in record.task.local if line.key == _DEVICE and line.words)
    return Agreement(record.task.outputs, frozenset(devices))


def further(agreed: Mapping[str, Agreement], now: Mapping[str, Agreement]) -> Mapping[str, Agreement]:
    """What tasks write and touch beyond what was agreed to, by tasks; those that do no more are not among them."""
    more = {}
    for name, agreement in now.items():
        before = agreed.get(name, _NOTHING)
        added = Agreement(agreement.writes - before.writes, agreement.touches - before.touches)
        if added != _NOTHING:
            more[name] = added
    return more
