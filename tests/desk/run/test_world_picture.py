import sys

import pytest

from onika.desk.run import world_picture
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def drawer(monkeypatch):
    """A drawing program given by its code."""

    def use(code):
        monkeypatch.setattr(world_picture, "DRAWER", (sys.executable, "-c", code))

    return use


def test_a_snapshot_is_handed_to_the_drawing_program(drawer, tmp_path):
    drawer("import sys; open(sys.argv[1], 'wb').write(sys.stdin.buffer.read()[::-1])")
    assert world_picture.draw(b"abc", tmp_path / "out.png") == NOTHING
    assert (tmp_path / "out.png").read_bytes() == b"cba"


@pytest.mark.parametrize(
    ("code", "complaint"),
    [
        ("import sys; print('first', file=sys.stderr); sys.exit('no OpenGL: install it')", "no OpenGL: install it"),
        ("print('only said aloud'); raise SystemExit(2)", "only said aloud"),
        ("raise SystemExit(3)", str(Reason.of("desk.no_opengl"))),
        ("raise SystemExit(7)", "no picture: the drawing program ended with code 7"),
    ],
)
def test_what_the_drawing_program_says_is_passed_on(drawer, tmp_path, code, complaint):
    drawer(code)
    assert str(world_picture.draw(b"", tmp_path / "out.png")) == complaint


def test_a_drawing_program_that_never_ends_is_ended(drawer, tmp_path, monkeypatch):
    monkeypatch.setattr(world_picture, "_PATIENCE_S", 0.05)
    drawer("while True: pass")
    assert str(world_picture.draw(b"", tmp_path / "out.png")) == "no picture: drawing took longer than 0.05 s"


def test_a_folder_that_is_not_there_is_told_before_anything_is_drawn(drawer, tmp_path):
    drawer("raise SystemExit(9)")
    complaint = world_picture.draw(b"", tmp_path / "nowhere" / "out.png")
    assert (
        str(complaint) == f"no picture: expected a folder that can be written to, found none at {tmp_path / 'nowhere'}"
    )
