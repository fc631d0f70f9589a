"""Draws a picture of a world: a separate program renders the snapshot, so that nothing here needs graphics."""

import os
import subprocess
import sys
from pathlib import Path

from onika.words.reason import NOTHING, Reason

DRAWER = (sys.executable, "-m", "onika.workcell.picture")
_PATIENCE_S = 60
NO_OPENGL = 3
"""How it ends where this machine cannot draw."""


def draw(snapshot: bytes, path: Path) -> Reason:
    """Draw a snapshot into a PNG file; what went wrong, nothing where it is drawn."""
    if not os.access(path.parent, os.W_OK):
        return Reason.of("desk.no_picture_folder", folder=str(path.parent))
    try:
        drawn = subprocess.run(  # noqa: S603 - our own program
            [*DRAWER, str(path)], input=snapshot, capture_output=True, timeout=_PATIENCE_S, check=False
        )
    except subprocess.TimeoutExpired:
        return Reason.of("desk.picture_late", seconds=_PATIENCE_S)
    if drawn.returncode == 0:
        return NOTHING
    if drawn.returncode == NO_OPENGL:
        return Reason.of("desk.no_opengl")
    output = (drawn.stderr or drawn.stdout).decode("utf-8", "replace").strip()
    if output:
        return Reason.plain(output.splitlines()[-1])
    return Reason.of("desk.picture_failed", code=drawn.returncode)
