"""How the tasks or icons of a base directory are arranged: read from the file beside them, and written to it (D24).

What comes with Onika is never written: how that is arranged stands in the user's own base directory.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from onika.files import arrangement
from onika.files.arrangement import Arrangement
from onika.store.opened_text import Faults, OpenedText, open_file, save
from onika.store.shipped import is_shipped, not_written
from onika.words.fault import Refusal
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class FolderArrangement:
    """Where the order of a folder stands (`module` or `dict`): in which file, and under which name there."""

    file: Path
    section: str

    @staticmethod
    def of(folder: Path, own: Path | None) -> "FolderArrangement | Refusal":
        """Of a folder of a base directory; `own` is the base directory of the user's own."""
        if not is_shipped(folder):
            return FolderArrangement(folder / arrangement.NAME, arrangement.HERE)
        if own is None:
            return Refusal(not_written(folder))
        return FolderArrangement(own / folder.name / arrangement.NAME, folder.parent.name)

    def names(self) -> tuple[tuple[str, ...], Faults]:
        """The names in their order; none where nobody has arranged them, or the file is at fault."""
        opened, faults = self._opened()
        return (opened.value.get(self.section, ()) if opened else ()), faults

    def saved(self, names: Sequence[str]) -> Refusal | None:
        """Write another order; refused where the file is at fault, or cannot be written."""
        opened, faults = self._opened()
        if faults:
            return Refusal(Reason.of("store.arrangement_at_fault", path=str(self.file), why=faults[0].reason))
        former: Arrangement = opened.value if opened else {}
        changed = {**former, self.section: tuple(names)}
        written = save(self.file, changed, arrangement.write, opened, overwrites=False)
        return written if isinstance(written, Refusal) else None

    def _opened(self) -> tuple[OpenedText[Arrangement] | None, Faults]:
        if not self.file.exists():
            return None, ()
        return open_file(self.file, arrangement.NAME, arrangement.read)


def in_order(names: Sequence[str], arranged: Sequence[str]) -> list[str]:
    """Names as they are arranged; those that nobody has placed come behind, in their own order."""
    places = {name: place for place, name in enumerate(arranged)}
    return sorted(names, key=lambda name: places.get(name, len(places)))
