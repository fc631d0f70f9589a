"""The chosen files are copied."""

import filecmp
import os
from pathlib import Path

from onika.module import AskAgain, Input, InVar, Module, ModuleError, OutVar, finish

_PIECE = 1 << 22


class CopyFiles(Module):
    """Copies the chosen files into another folder, which it makes where there is none.

    Nothing is written over: what is there already under the same name with the same content is left as it is, and
    with another content the copy gets a number. A file is there whole or not at all. At most 4 MiB are copied in a
    cycle.

    Kind     trigger, periodic, 1..100 Hz
    Ports    INVAR  FOLDER       line         -  the folder
             INVAR  FILES        byte[65536]  -  names of the chosen files in UTF-8, a slash behind each
             OUTVAR NEXT_FOLDER  line         -  the folder, for the next job
             OUTVAR NEXT_FILES   byte[65536]  -  the names, for the next job
             OUTVAR COPIED       int          -  how many are there now
    Input    folder              line         -  path of the folder to copy into; ~ is the home directory
    Finish   flow 0, loop FALSE, when all have been copied
    Errors   no folder      it cannot be made, or is the one the files are in: another one is asked for
             not copied     a file is gone, or there is no room: ERROR; what was copied stays
    Get/Set  copied, how many are there now / -
    Source   dissertation §7
    """

    trigger = True

    folder = Input("line", "-", "path of the folder to copy into; ~ is the home directory")
    FOLDER = InVar("line", "-", "the folder")
    FILES = InVar("byte[65536]", "-", "names of the chosen files in UTF-8, a slash behind each")
    NEXT_FOLDER = OutVar("line", "-", "the folder, for the next job")
    NEXT_FILES = OutVar("byte[65536]", "-", "the names, for the next job")
    COPIED = OutVar("int", "-", "how many are there now")

    def on(self, inputs):
        target = Path(inputs.folder.strip()).expanduser()
        if not target.is_absolute():
            raise AskAgain("expected a path that begins with / or ~, found {folder}", folder=str(target))
        try:
            target.mkdir(parents=True, exist_ok=True)
        except OSError as wrong:
            raise AskAgain(
                "expected a folder, found {folder}: {why}", folder=str(target), why=wrong.strerror or str(wrong)
            ) from None
        if target.resolve() == Path(self.FOLDER).resolve():
            raise AskAgain("expected another folder than the one the files are in, found {folder}", folder=str(target))
        self.NEXT_FOLDER, self.NEXT_FILES = self.FOLDER, self.FILES
        self.COPIED = 0
        self._work = self._copy(target)

    def cycle(self):
        try:
            for _ in self._work:
                return None
        except (OSError, ValueError) as wrong:
            raise ModuleError(
                "expected to copy all, copied {count}: {why}", count=self.COPIED, why=str(wrong)
            ) from None
        return finish()

    def off(self):
        self._work.close()  # a copy that is half made goes

    def get(self, name):
        return self.COPIED if name == "copied" else super().get(name)

    def _copy(self, target):
        """Copy one after the other; it pauses between two pieces."""
        for name in os.fsdecode(bytes(self.FILES).rstrip(b"\0")).split("/")[:-1]:
            source = Path(self.FOLDER) / name
            place = self._place(source, target)
            if place is not None:
                yield from self._write(source, place)
            self.COPIED += 1
            yield

    def _place(self, source, target):
        """Where a copy is to lie; None: it lies there already."""
        place, number = target / source.name, 1
        while place.exists():
            if filecmp.cmp(source, place, shallow=False):
                return None
            number += 1
            place = target / f"{source.stem} {number}{source.suffix}"
        return place

    def _write(self, source, place):
        unfinished = place.with_name(f".{place.name}.part")
        try:
            with source.open("rb") as content, unfinished.open("wb") as copy:
                while piece := content.read(_PIECE):
                    copy.write(piece)
                    yield
            found = source.stat()
            os.utime(unfinished, ns=(found.st_atime_ns, found.st_mtime_ns))
            os.link(unfinished, place)  # unlike a renaming this never replaces what somebody else put there meanwhile
        finally:
            unfinished.unlink(missing_ok=True)
