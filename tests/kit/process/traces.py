"""The traces that a program leaves on a machine: processes, named shared memory, temporary files.

Every process of the program carries a mark in its environment, which it hands on to all that it starts; so that also
one is found that has left the family, its session and its process group.
"""

import os
import select
import signal
from contextlib import suppress
from pathlib import Path
from time import monotonic
from uuid import uuid4

_MARK = "ONIKA_TRACED"
_NAMED_MEMORY = Path("/dev/shm")


class Traces:
    """What is left of one program, which is started with `environment`; `folder` takes its home and temporary files."""

    def __init__(self, folder: Path) -> None:
        self.temporary, self.home = folder / "tmp", folder / "home"
        for path in (self.temporary, self.home):
            path.mkdir(parents=True, exist_ok=True)
        self._mark = f"{_MARK}={uuid4().hex}"
        self._named_before = _named()

    @property
    def environment(self) -> dict[str, str]:
        """What the program is to find in its environment."""
        name, _, mark = self._mark.partition("=")
        state = str(self.home / "state")
        return {name: mark, "TMPDIR": str(self.temporary), "HOME": str(self.home), "XDG_STATE_HOME": state}

    def processes(self) -> dict[int, str]:
        """Every living process of the program with its command line."""
        return {int(path.name): words for path in _numbered() if (words := self._words(path))}

    def left_over(self, within_s: float) -> list[str]:
        """What is still there after so long: processes, named memory, temporary files."""
        until = monotonic() + within_s
        while (left := self._left()) and monotonic() < until:
            select.select([], [], [], 0.02)
        return left

    def end(self) -> None:
        """End what is left, whatever it is."""
        for pid in self.processes():
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)

    def _left(self) -> list[str]:
        files = [str(path) for path in self.temporary.rglob("*")]
        files += [str(path) for path in self.home.rglob("*.saving")]
        return [*self.processes().values(), *sorted(_named() - self._named_before), *files]

    def _words(self, path: Path) -> str:
        try:
            if self._mark.encode() not in (path / "environ").read_bytes().split(b"\0"):
                return ""
            return (path / "cmdline").read_bytes().replace(b"\0", b" ").decode("utf-8", "replace")
        except OSError:
            return ""


def _numbered() -> list[Path]:
    return [path for path in Path("/proc").iterdir() if path.name.isdigit()]


def _named() -> set[str]:
    """Named segments and semaphores, but those of browsers, which others start beside."""
    if not _NAMED_MEMORY.is_dir():
        return set()
    return {str(path) for path in _NAMED_MEMORY.iterdir() if not path.name.startswith((".org.chromium", ".com.google"))}
