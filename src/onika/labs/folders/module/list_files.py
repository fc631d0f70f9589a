"""The chosen files are listed."""

import csv
import io
import os
from datetime import UTC, datetime
from pathlib import Path

from onika.module import AskAgain, Input, InVar, Module, ModuleError, OutVar, finish


class ListFiles(Module):
    """Writes a table of the chosen files: name, bytes, last change; for a spreadsheet.

    Kind     trigger, periodic, 1..100 Hz
    Ports    INVAR  FOLDER       line         -  the folder
             INVAR  FILES        byte[65536]  -  names of the chosen files in UTF-8, a slash behind each
             OUTVAR NEXT_FOLDER  line         -  the folder, for the next job
             OUTVAR NEXT_FILES   byte[65536]  -  the names, for the next job
    Input    file                string       -  path of the table (CSV), which is written anew; ~ is the home directory
    Finish   flow 0, loop FALSE, at its first cycle
    Errors   no place       the table lies in no folder: another path is asked for
             not written    a file is gone, or the table cannot be written: ERROR; a table that was there stays
    Source   dissertation §7
    """

    trigger = True

    file = Input("string", "-", "path of the table (CSV), which is written anew; ~ is the home directory")
    FOLDER = InVar("line", "-", "the folder")
    FILES = InVar("byte[65536]", "-", "names of the chosen files in UTF-8, a slash behind each")
    NEXT_FOLDER = OutVar("line", "-", "the folder, for the next job")
    NEXT_FILES = OutVar("byte[65536]", "-", "the names, for the next job")

    def on(self, inputs):
        self._table = Path(inputs.file.strip()).expanduser()
        if not self._table.is_absolute() or not self._table.parent.is_dir():
            raise AskAgain(
                "expected a path in a folder that is there, from / or ~ on, found {path}", path=str(self._table)
            )
        self.NEXT_FOLDER, self.NEXT_FILES = self.FOLDER, self.FILES

    def cycle(self):
        unfinished = self._table.with_name(f".{self._table.name}.part")
        try:
            unfinished.write_text(self._rows(), encoding="utf-8", errors="replace")
            unfinished.replace(self._table)
        except (OSError, ValueError) as wrong:
            raise ModuleError(
                "expected to write the table {path}: {why}", path=str(self._table), why=str(wrong)
            ) from None
        return finish()

    def _rows(self):
        rows = io.StringIO()
        writer = csv.writer(rows)
        writer.writerow(("name", "bytes", "changed"))
        for name in os.fsdecode(bytes(self.FILES).rstrip(b"\0")).split("/")[:-1]:
            found = (Path(self.FOLDER) / name).stat()
            changed = datetime.fromtimestamp(found.st_mtime, UTC)
            writer.writerow((name, found.st_size, changed.strftime("%Y-%m-%d %H:%M")))
        return rows.getvalue()
