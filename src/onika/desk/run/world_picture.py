"""Draws a picture of a world: a separate program renders the snapshot, so that nothing here needs graphics."""

import os
import subprocess
import sys
from pathlib import Path

DRAWER = (sys.executable, "-m", "onika.workcell.picture")
_PATIENCE_S = 60


def draw(snapshot: bytes, path: Path) -> str:
    """Draw a snapshot into a PNG file; what went wrong in words, or an empty text."""
    if not os.access(path.parent, os.W_OK):
        return f"no picture: expected a folder that can be written to, found none at {path.parent}"
    try:
        drawn = subprocess.run(  # noqa: S603 - our own program
            [*DRAWER, str(path)], input=snapshot, capture_output=True, timeout=_PATIENCE_S, check=False
        )
    except subprocess.TimeoutExpired:
        return f"no picture: drawing took longer than {_PATIENCE_S} s"
    if drawn.returncode == 0:
        return ""
    output = (drawn.stderr or drawn.stdout).decode("utf-8", "replace").strip()
    if output:
        return output.splitlines()[-1]
    return f"no picture: the drawing program ended with code {drawn.returncode}"
