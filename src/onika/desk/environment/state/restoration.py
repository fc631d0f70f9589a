"""How what a user has changed outside open files is put back: by an act, or as the text of a file (requirement X10)."""

from dataclasses import dataclass
from pathlib import Path

from onika.desk.environment.state.history import History, UndoStep
from onika.files import whole
from onika.wire import act
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class FileText:
    """A file with its whole text; None: there is no such file."""

    path: Path
    text: str | None

    @staticmethod
    def of(path: Path) -> "FileText":
        """The file as it is now; one that cannot be read counts as none."""
        content, _ = whole.read(path)
        return FileText(path, content[0] if content is not None else None)


Restoration = act.Prefer | act.SetButton | act.LibraryRate | FileText
OwnStep = UndoStep[Restoration]
OwnHistory = History[Restoration]


def own_step(label: Reason, before: Restoration, after: Restoration) -> OwnStep:
    """A change of nothing that is open; by whom it was is said where it is kept."""
    return UndoStep(label, "", before, after)
