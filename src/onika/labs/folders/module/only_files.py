"""Only some of the chosen files."""

import hashlib
import os
import time
from collections import Counter
from fnmatch import fnmatch
from pathlib import Path

import numpy as np

from onika.module import AskAgain, Input, InVar, Module, ModuleError, OutVar, finish

_DAY_S = 86_400.0
_MEGABYTE = 1_000_000
_PIECE = 1 << 22
_MEASURES = {
    "newer": lambda found, days: found.st_mtime >= time.time() - days * _DAY_S,
    "older": lambda found, days: found.st_mtime < time.time() - days * _DAY_S,
    "larger": lambda found, megabytes: found.st_size > megabytes * _MEGABYTE,
}


class OnlyFiles(Module):
    """Leaves only those of the chosen files that have a name, an age, a size, or a twin with the same content.

    It reads at most 4 MiB of content in a cycle, so that it never holds up others.

    Kind     trigger, periodic, 1..100 Hz
    Ports    INVAR  FOLDER       line         -  the folder
             INVAR  FILES        byte[65536]  -  names of the chosen files in UTF-8, a slash behind each
             OUTVAR NEXT_FOLDER  line         -  the folder
             OUTVAR NEXT_FILES   byte[65536]  -  the names of those that remain, written alike
    Input    which               line         -  *.jpg *.png; newer DAYS; older DAYS; larger MEGABYTES; twins
    Finish   flow 1, loop TRUE where files remain, else flow 0, loop FALSE; when all have been looked at
    Errors   not understood      it is none of these forms: another one is asked for
             a file is gone      it was chosen, and is no more or cannot be read: ERROR
    Source   dissertation §7
    """

    trigger = True

    which = Input("line", "-", "*.jpg *.png; newer DAYS; older DAYS; larger MEGABYTES; twins")
    FOLDER = InVar("line", "-", "the folder")
    FILES = InVar("byte[65536]", "-", "names of the chosen files in UTF-8, a slash behind each")
    NEXT_FOLDER = OutVar("line", "-", "the folder")
    NEXT_FILES = OutVar("byte[65536]", "-", "the names of those that remain, written alike")

    def on(self, inputs):
        self._words = inputs.which.split()
        verb, *rest = self._words or [""]
        if verb in _MEASURES:
            self._amount = self._number(inputs.which, rest)
        elif verb != "twins" and not any(sign in "*?." for sign in inputs.which):
            raise self._strange(inputs.which)
        self.NEXT_FOLDER, self.NEXT_FILES = self.FOLDER, self.FILES
        self._work = self._look()

    def cycle(self):
        try:
            for _ in self._work:
                return None
        except (OSError, ValueError) as wrong:
            raise ModuleError("a file is not as it was when it was chosen: {why}", why=str(wrong)) from None
        remains = bool(self.NEXT_FILES[0])
        return finish(int(remains), loop=remains)

    def _number(self, which, rest):
        try:
            (amount,) = map(float, rest)
        except ValueError:
            raise self._strange(which) from None
        return amount

    def _strange(self, which):
        return AskAgain("expected *.jpg or such, newer 30, older 365, larger 5 or twins, found {which}", which=which)

    def _look(self):
        """Choose anew; it pauses between two pieces of content, and until all has been passed on."""
        names = os.fsdecode(bytes(self.FILES).rstrip(b"\0")).split("/")[:-1]
        paths = [Path(self.FOLDER) / name for name in names]
        remaining = (yield from self._twins(paths)) if self._words[0] == "twins" else list(filter(self._fits, paths))
        written = os.fsencode("".join(f"{path.name}/" for path in remaining))
        self.NEXT_FILES = 0
        self.NEXT_FILES[: len(written)] = np.frombuffer(written, np.uint8)
        for _ in range(2):
            yield

    def _fits(self, path):
        measure = _MEASURES.get(self._words[0])
        if measure is not None:
            return measure(path.stat(), self._amount)
        return any(fnmatch(path.name.lower(), pattern.lower()) for pattern in self._words)

    def _twins(self, paths):
        """Those with the same content as another one; only what is equally long is read."""
        sizes = {path: path.stat().st_size for path in paths}
        many = Counter(sizes.values())
        digests = {}
        for path in (path for path in paths if many[sizes[path]] > 1):
            digest = hashlib.sha256()
            with path.open("rb") as content:
                while piece := content.read(_PIECE):
                    digest.update(piece)
                    yield
            digests[path] = digest.digest()
        equal = Counter(digests.values())
        return [path for path, digest in digests.items() if equal[digest] > 1]
