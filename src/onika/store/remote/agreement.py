"""What the tasks of a library say that they write and touch, and what of it nobody has agreed to (X16)."""

from collections.abc import Mapping

from onika.files import rmod
from onika.files.library_index import LibraryIndex
from onika.files.library_lock import Agreement

_DEVICE = "DEVICE"
_OUTPUTS = ("OUTCONST", "OUTVAR")
_NONE = "none"
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


def stays_within(content: bytes, agreed: Agreement) -> bool:
    """Whether the file of a task surely says no more than was agreed to; where that is not plain, it is to be read.

    Every word of the lines in question counts, so whatever a reader makes of them is among what is looked at.
    """
    aliases: dict[str, set[str]] = {}
    outputs: set[str] = set()
    for line in content.decode("utf-8", "replace").splitlines():
        keyword, *words = line.split() or [""]
        if keyword == "SVARALIAS":
            name, _, svar = "".join(words).partition("=")
            aliases.setdefault(name, set()).add(svar)
        elif keyword in _OUTPUTS:
            outputs.update(words)
        elif keyword == _DEVICE and not agreed.touches.issuperset(words[:1]):
            return False
    written = {svar for name in outputs - {_NONE} for svar in aliases.get(name, {name})}
    return agreed.writes >= written


def further(agreed: Mapping[str, Agreement], now: Mapping[str, Agreement]) -> Mapping[str, Agreement]:
    """What tasks write and touch beyond what was agreed to, by tasks; those that do no more are not among them."""
    more = {}
    for name, agreement in now.items():
        before = agreed.get(name, _NOTHING)
        added = Agreement(agreement.writes - before.writes, agreement.touches - before.touches)
        if added != _NOTHING:
            more[name] = added
    return more
