"""The C compiler of this machine."""

import shutil


def compiler() -> str:
    """It; raises FileNotFoundError where there is none."""
    found = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if found is None:
        raise FileNotFoundError("no C compiler is installed (cc, gcc or clang)")
    return found
