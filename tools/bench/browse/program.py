"""Onika with the page, as a process, and the lines in which results are told."""

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def program(*words: str) -> Iterator[tuple[str, int, Callable[[], str]]]:
    """Onika with the page: its address, its process, and the next address for another browser."""
    with tempfile.TemporaryDirectory() as state:
        environment = {**os.environ, "XDG_STATE_HOME": state}
        started = subprocess.Popen(
            [
                sys.executable,
                "-c",
                "import sys; from onika.cli import main; sys.exit(main())",
                "--port",
                "0",
                "--no-browser",
                *words,
            ],
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
        )
        try:
            lines = started.stdout or ()

            def following() -> str:
                return next(found[0] for line in lines if (found := re.search(r"http://\S+", line)))

            yield following(), started.pid, following
        finally:
            started.terminate()
            started.wait(20)


def said(title: str, value: str) -> None:
    """One line."""
    print(f"{title:<62}{value:>18}", flush=True)
