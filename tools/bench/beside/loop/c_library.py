"""The four blocks in C, as a shared library that is made once for each process."""

import ctypes
import subprocess
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from beside.compiler import compiler

SOURCE = Path(__file__).with_name("blocks.c")

Function = Callable[..., None]


@cache
def library() -> ctypes.CDLL:
    """The library; raises FileNotFoundError where there is no compiler."""
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "blocks.so"
        flags = ("-O2", "-Wall", "-Wextra", "-shared", "-fPIC")
        subprocess.run([compiler(), *flags, "-o", made, SOURCE, "-lm"], check=True)
        return ctypes.CDLL(str(made))  # stays loaded when the file is gone


def function(name: str, *types: Any) -> Function:
    """One of its functions, with the types of its arguments: arrays unless others are named."""
    found = library()[name]
    found.restype = None
    found.argtypes = types
    return found


def place(array: "NDArray[Any]") -> ctypes.c_void_p:
    """Where an array lies: taken once, for it costs more than the call does."""
    return ctypes.c_void_p(array.ctypes.data)
