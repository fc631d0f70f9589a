"""What saving and going back have replaced: the last hundred texts, each to be brought back (requirement X10).

They lie in a folder of the state directory, a file each. Several programs of ours may keep texts there at a time.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import msgspec

from onika.files import text as texts, whole
from onika.files.state.state_directory import make_own
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason

MOST = 100
FOLDER = "replaced"
_ENDING = ".json"
_TRIES = 100
"""Numbers that are tried while other programs keep texts too."""


class ReplacedText(msgspec.Struct, frozen=True):
    """A text that a file held: which file, and until when, in s since 1970."""

    path: str
    moment_s: float
    text: str
    number: int = 0


@dataclass(frozen=True, slots=True)
class ReplacedTexts:
    """The texts below a state directory."""

    state: Path

    def keep(self, path: Path, text: str, moment_s: float) -> Refusal | None:
        """Keep what a file held; the oldest beyond the hundredth is thrown away."""
        folder = self.state / FOLDER
        try:
            make_own(folder)
            numbers = self._numbers()
        except OSError as error:
            return Refusal(Reason.of("store.not_kept", path=str(path), why=system_reason(error)))
        line = msgspec.json.encode(ReplacedText(str(path), moment_s, text)).decode()
        first = max(numbers, default=0) + 1
        for number in range(first, first + _TRIES):
            written = whole.write(folder / f"{number:08}{_ENDING}", line, whole.ABSENT)
            if not isinstance(written, Refusal):
                self._forget((*numbers, number))
                return None
            if not (folder / f"{number:08}{_ENDING}").exists():
                return Refusal(Reason.of("store.not_kept", path=str(path), why=written.reason))
        return Refusal(Reason.of("store.not_kept", path=str(path), why=Reason.of("store.kept_by_many")))

    def listed(self) -> tuple[ReplacedText, ...]:
        """What is kept, the newest first; what cannot be read is left out."""
        return tuple(self._read())

    def find(self, number: int) -> ReplacedText | None:
        """The text of this number."""
        return next((replaced for replaced in self._read() if replaced.number == number), None)

    def _read(self) -> Iterator[ReplacedText]:
        try:
            numbers = self._numbers()
        except OSError:
            return
        for number in sorted(numbers, reverse=True)[:MOST]:
            content, _ = texts.load(self._file(number), str(self._file(number)))
            with suppress(msgspec.DecodeError, msgspec.ValidationError):
                if content is not None:
                    replaced = msgspec.json.decode(content, type=ReplacedText)
                    yield msgspec.structs.replace(replaced, number=number)

    def _numbers(self) -> list[int]:
        folder = self.state / FOLDER
        if not folder.is_dir():
            return []
        stems = (path.stem for path in folder.iterdir() if path.suffix == _ENDING)
        return [int(stem) for stem in stems if stem.isdecimal() and stem.isascii()]

    def _forget(self, numbers: tuple[int, ...]) -> None:
        for number in sorted(numbers)[:-MOST]:
            with suppress(OSError):
                self._file(number).unlink()

    def _file(self, number: int) -> Path:
        return self.state / FOLDER / f"{number:08}{_ENDING}"
