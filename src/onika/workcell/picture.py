"""A picture of a snapshot: `python -m onika.workcell.picture OUT.png < snapshot` draws a world without a screen.

It is a program of its own, so that drawing never happens in a process that keeps time. Exit 0: drawn; 2: wrong words on
the command line or no snapshot on the input; 3: this machine cannot draw, and what to install.
"""

import os
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import numpy.typing as npt

from onika.workcell.snapshot import WorldSnapshot, decode
from onika.workcell.view import CAMERA

SIZE = (1440, 960)
"""Width and height in pixels."""

MISSING = (
    "expected OpenGL without a screen, found none that works; no picture was drawn. "
    "Install libegl1 libegl-mesa0 libgl1-mesa-dri, or libosmesa6 (names of Debian's packages)."
)

_WAYS = ("egl", "osmesa")
_WAY = "MUJOCO_GL"

_EMPTY = f'<mujoco><worldbody><camera name="{CAMERA}" pos="0 0 1"/></worldbody></mujoco>'
"""A world to draw when only the drawing matters."""

Pixels = npt.NDArray[np.uint8]


def main(words: list[str]) -> int:
    """Draw the snapshot on the standard input into the file named; gives the exit code."""
    if words == ["--probe"]:
        return _probe()
    if len(words) != 1:
        return _say("usage: python -m onika.workcell.picture OUT.png < snapshot", 2)
    data = sys.stdin.buffer.read()
    try:
        snapshot = decode(data)
    except ValueError as fault:
        return _say(f"expected a snapshot on the standard input, found something else: {fault}", 2)
    if _WAY not in os.environ:
        return _in_a_child(words[0], data)
    try:
        pixels = draw(snapshot)
    # whatever a graphics driver or its loader raises means the same here
    except Exception as fault:
        return _say(f"{MISSING} ({os.environ[_WAY]}: {fault})", 3)
    Path(words[0]).write_bytes(png(pixels))
    return 0


def _probe() -> int:
    """Say in which way this machine can draw, by drawing nothing."""
    if _WAY not in os.environ:
        return _in_a_child("--probe", b"")
    try:
        draw(WorldSnapshot(_EMPTY, 0.0), (64, 48))
    # whatever a graphics driver or its loader raises means the same here
    except Exception as fault:
        return _say(f"{MISSING} ({os.environ[_WAY]}: {fault})", 3)
    return _say(os.environ[_WAY], 0)


def draw(snapshot: WorldSnapshot, size: tuple[int, int] = SIZE) -> Pixels:
    """The picture as uint8[height,width,3]; MUJOCO_GL must name a way to draw before MuJoCo is imported."""
    import mujoco  # it looks for OpenGL when imported, so not before it is told where

    model = mujoco.MjModel.from_xml_string(snapshot.mjcf)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    renderer = mujoco.Renderer(model, size[1], size[0])
    try:
        renderer.update_scene(data, camera=CAMERA)
        pixels: Pixels = renderer.render()
    finally:
        renderer.close()
    return pixels


def png(pixels: Pixels, effort: int = 9) -> bytes:
    """A PNG file of uint8[height,width,3] (RFC 2083), each line as its difference to the one above.

    `effort` is how much time goes into making it small, 1 to 9.
    """
    height, width, _ = pixels.shape
    lines = pixels.reshape(height, width * 3)
    rows = np.empty((height, 1 + width * 3), dtype=np.uint8)
    rows[:, 0] = 2
    rows[0, 1:] = lines[0]
    np.subtract(lines[1:], lines[:-1], out=rows[1:, 1:])
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows.tobytes(), effort)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(tag, data) for tag, data in chunks)


def _in_a_child(file: str, data: bytes) -> int:
    """Try one way after the other, each in a process of its own: one that fails may take its process with it."""
    command = [sys.executable, "-m", "onika.workcell.picture", file]
    for way in _WAYS:
        done = subprocess.run(command, input=data, env={**os.environ, _WAY: way}, capture_output=True, check=False)  # noqa: S603 - this very program
        if done.returncode == 0:
            sys.stderr.write(done.stderr.decode("utf-8", "replace"))
            return 0
    return _say(MISSING, 3)


def _chunk(tag: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))


def _say(sentence: str, code: int) -> int:
    sys.stderr.write(sentence + "\n")
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
