"""The C compiler of this machine."""

import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def compiler() -> str:
    """It; raises FileNotFoundError where there is none."""
    found = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if found is None:
        raise FileNotFoundError("no C compiler is installed (cc, gcc or clang)")
    return found


@contextmanager
def built(source: Path) -> Iterator[tuple[Path, str]]:
    """A program made of one source in C, while it is needed, and the version of the compiler."""
    with tempfile.TemporaryDirectory() as folder:
        program, made = Path(folder) / source.stem, compiler()
        subprocess.run([made, "-O2", "-Wall", "-Wextra", "-o", program, source], check=True)
        said = subprocess.run([made, "--version"], capture_output=True, text=True, check=True).stdout
        yield program, said.splitlines()[0]
