import os
import struct
import subprocess
import sys
import zlib

import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from onika.workcell.picture import MISSING, main, png

COMMAND = [sys.executable, "-m", "onika.workcell.picture"]


def test_a_png_holds_every_pixel():
    pixels = np.random.default_rng(0).integers(0, 256, (7, 5, 3), dtype=np.uint8)
    data = png(pixels)
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, place = {}, 8
    while place < len(data):
        (length,) = struct.unpack_from(">I", data, place)
        tag, body = data[place + 4 : place + 8], data[place + 8 : place + 8 + length]
        assert struct.unpack_from(">I", data, place + 8 + length)[0] == zlib.crc32(tag + body)
        chunks[tag], place = body, place + 12 + length
    assert list(chunks) == [b"IHDR", b"IDAT", b"IEND"]
    assert struct.unpack(">IIBB", chunks[b"IHDR"][:10]) == (5, 7, 8, 2)
    rows = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), dtype=np.uint8).reshape(7, 16)
    assert (rows[:, 0] == 2).all()  # each line as the difference to the one above
    assert np.array_equal(np.cumsum(rows[:, 1:], axis=0, dtype=np.uint8).reshape(7, 5, 3), pixels)


def test_without_a_file_name_it_says_how_it_is_used(capsys):
    assert main([]) == 2
    assert "OUT.png" in capsys.readouterr().err


@pytest.mark.site
def test_something_else_than_a_snapshot_is_refused(tmp_path):
    done = subprocess.run([*COMMAND, tmp_path / "out.png"], input=b"\x01nonsense", capture_output=True, check=False)
    assert done.returncode == 2
    assert b"expected a snapshot" in done.stderr


@pytest.mark.site
def test_without_opengl_it_says_what_to_install(tmp_path):
    done = subprocess.run(
        [*COMMAND, tmp_path / "out.png"],
        input=boxes_world().snapshot(),
        env={**os.environ, "MUJOCO_GL": "disable"},
        capture_output=True,
        check=False,
    )
    assert done.returncode == 3
    assert MISSING in done.stderr.decode()
    assert not (tmp_path / "out.png").exists()


@pytest.mark.site
def test_a_snapshot_becomes_a_picture_where_opengl_is_there(tmp_path):
    world = boxes_world()
    world.claim("arm_left", 1)
    done = subprocess.run([*COMMAND, tmp_path / "out.png"], input=world.snapshot(), capture_output=True, check=False)
    if done.returncode == 3:
        pytest.skip("this machine has no OpenGL")
    assert done.returncode == 0, done.stderr
    assert struct.unpack(">II", (tmp_path / "out.png").read_bytes()[16:24]) == (1440, 960)
