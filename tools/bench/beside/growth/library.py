"""A library of so many task files, one of a hundred broken: how long it takes to open it."""

import tempfile
from pathlib import Path

import library

import onika
from beside.contestant import Figures, serve
from onika.store.base_directory import BaseDirectory

OPENINGS = 1000


def main() -> None:
    """The contestant; a size is a number of files, which are written once."""
    known: dict[int, BaseDirectory] = {}
    with tempfile.TemporaryDirectory() as folder:

        def measure(files: int) -> Figures:
            if files not in known:
                known[files] = BaseDirectory(Path(folder) / str(files))
                library.fill(known[files].path, files)
            return {"figure": library.seconds(known[files], max(1, OPENINGS // files)) * 1e3}

        serve(onika.__version__, measure)


if __name__ == "__main__":
    main()
