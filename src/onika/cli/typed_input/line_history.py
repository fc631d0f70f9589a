"""The lines that were typed at a console, kept in a file for the next one (requirement A16)."""

from pathlib import Path

from prompt_toolkit.history import InMemoryHistory

from onika.files.state.state_directory import make_own

_KEPT = 1000
_LONGEST = 4000
"""Letters of a line that is kept; longer ones are there until the console ends."""


class LineHistory(InMemoryHistory):
    """Blank lines are left out, and a line that is typed twice in a row is there once.

    `path` is the file; nothing is kept where it is None or cannot be written.
    """

    def __init__(self, path: Path | None) -> None:
        super().__init__(_former(path))
        self._path = path

    def append_string(self, string: str) -> None:
        """Take up the lines of a text."""
        for line in string.splitlines():
            if line.strip() and self.get_strings()[-1:] != [line]:
                super().append_string(line)

    def keep(self) -> None:
        """Write the last lines for the next console; that they cannot be kept is no reason to complain."""
        if self._path is None:
            return
        lines = [line for line in self.load_history_strings() if len(line) <= _LONGEST][:_KEPT]
        try:
            make_own(self._path.parent)
            self._path.touch(mode=0o600)
            self._path.write_text("".join(line + "\n" for line in reversed(lines)), encoding="utf-8")
        except OSError:
            pass


def _former(path: Path | None) -> list[str]:
    try:
        if path is None:
            return []
        return path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return []
