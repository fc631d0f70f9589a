"""A folder is opened."""

import os
from pathlib import Path

import numpy as np

from onika.module import AskAgain, Input, Module, OutVar, finish


class OpenFolder(Module):
    """Chooses all files of a folder, without those that are hidden or lie in folders within it. It changes nothing.

    Kind     trigger, periodic, 1..100 Hz
    Ports    OUTVAR NEXT_FOLDER  line         -  the folder, from the root of the disk on
             OUTVAR NEXT_FILES   byte[65536]  -  the names of its files, in UTF-8, a slash behind each, then zeros
    Input    folder              line         -  path of the folder; ~ is the home directory
    Finish   flow 0, loop FALSE, at its third cycle, when all has been passed on
    Errors   no folder           there is none, it cannot be read, or has too many files: another one is asked for
    Source   dissertation §7
    """

    trigger = True

    folder = Input("line", "-", "path of the folder; ~ is the home directory")
    NEXT_FOLDER = OutVar("line", "-", "the folder, from the root of the disk on")
    NEXT_FILES = OutVar("byte[65536]", "-", "the names of its files, in UTF-8, a slash behind each, then zeros")

    def on(self, inputs):
        folder = Path(inputs.folder.strip()).expanduser()
        if not folder.is_absolute():
            raise AskAgain("expected a path that begins with / or ~, found {folder}", folder=str(folder))
        try:
            files = sorted(path.name for path in folder.iterdir() if path.is_file() and not path.name.startswith("."))
            written = os.fsencode("".join(f"{name}/" for name in files))
        except OSError as wrong:
            raise AskAgain(
                "expected a folder, found {folder}: {why}", folder=str(folder), why=wrong.strerror or str(wrong)
            ) from None
        if len(written) > self.NEXT_FILES.size:
            raise AskAgain("expected fewer files, found {count} in {folder}", count=len(files), folder=str(folder))
        self.NEXT_FOLDER = str(folder)
        self.NEXT_FILES = 0
        self.NEXT_FILES[: len(written)] = np.frombuffer(written, np.uint8)
        self._left = 3

    def cycle(self):
        self._left -= 1
        return finish() if not self._left else None
