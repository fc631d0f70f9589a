"""A world of files with its cameras. Where the machine cannot render, what needs pictures is left out."""

import numpy as np
import pytest

from kit.worlds.file_cells import files_of
from kit.worlds.filmed_cells import ABOVE, HAND, filmed
from onika.laws.pictures.blob import ColourBlob
from onika.ring.device import DriveState
from onika.workcell.filmed import filmed_world
from onika.workcell.filmed.filmed_world import FilmedWorld, judged
from onika.workcell.filmed.filming import Filming


@pytest.fixture
def seen():
    """Worlds in virtual time in which the upper camera is used."""
    worlds = []

    def make():
        world = FilmedWorld(filmed())
        worlds.append(world)
        world.render_in_step()
        world.look("above", True)
        world.step(300_000_000)
        if world.take_events():
            pytest.skip("this machine cannot render")
        return world

    yield make
    for world in worlds:
        world.look("above", False)


def test_cameras_of_the_world_and_of_its_robots_are_devices():  # R-F05, R-X19
    sheets = {sheet.name: sheet for sheet in FilmedWorld(filmed()).devices() if sheet.picture}
    assert {name: sheet.picture for name, sheet in sheets.items()} == {
        "above": (48, 64),
        "eye_left": (32, 32),
        "eye_right": (32, 32),
    }
    assert sheets["above"].state == ("time", "drive", "number", "age")
    assert sheets["above"].identity["FOCAL"] == pytest.approx((24 / np.tan(np.radians(15)),))
    assert judged(filmed()) == ()


def test_a_picture_shows_what_is_there_at_its_instant_the_same_every_time(seen):  # R-F05, R-X06
    world = seen()
    assert world.state("above").tolist() == pytest.approx([0.3, DriveState.DRIVEN, 7, 0.0])  # at 0, 50, … 300 ms
    u, v, count = ColourBlob((1, 0, 0), 40.0).middle(world.picture("above"))
    assert (u, v) == pytest.approx((31.5, 23.5), abs=1.0)
    assert count > 20
    assert np.array_equal(seen().picture("above"), world.picture("above"))
    world.step(340_000_000)
    assert world.state("above")[2:].tolist() == pytest.approx([7, 0.04])


def test_a_camera_moves_nothing(seen):  # R-X06
    plain, used = FilmedWorld(files_of()), seen()
    plain.step(300_000_000)
    assert used.fingerprint() == plain.fingerprint()


def test_nothing_is_rendered_where_nobody_looks(monkeypatch):  # R-F05
    monkeypatch.setattr("onika.workcell.filmed.filming.CameraRenderer", None)
    world = FilmedWorld(filmed())
    world.render_in_step()
    world.step(300_000_000)
    assert world.state("above")[2] == 0.0
    assert not world.picture("above").any()


def test_where_nothing_draws_cameras_have_tripped_and_all_else_goes_on(monkeypatch):  # R-F05, R-B07
    monkeypatch.setattr(filmed_world, "Filming", lambda files, cameras: Filming(files, cameras, ways=("nothing",)))
    world = FilmedWorld(filmed())
    world.render_in_step()
    world.look("above", True)
    world.step(200_000_000)
    (told,) = world.take_events()
    assert (told.device, told.state, told.cause.key) == ("above", DriveState.TRIPPED, "workcell.no_graphics")
    world.look("above", False)
    world.look("above", True)
    world.step(300_000_000)
    assert (world.take_events(), world.state("above")[1]) == ([], DriveState.TRIPPED)
    assert world.now_ns == 300_000_000


@pytest.mark.parametrize(
    ("above", "hand", "file", "line", "key"),
    [
        (ABOVE + "CAMERA side\nVIEW table.side\n", HAND, "cell.world", 31, "workcell.no_such_name"),
        (ABOVE + "CAMERA side\n", HAND, "cell.world", 30, "workcell.no_such_name"),
        (ABOVE.replace("AT 0.6", "ON cube.cube\nAT 0.6").replace("0.6 -0.9 0.06", "0 0 0"), HAND, "", 0, ""),
        (ABOVE.replace("AT 0.6", "ON shelf\nAT 0.6"), HAND, "cell.world", 25, "workcell.no_body_for_camera"),
        (ABOVE, "CAMERA eye\n", "elbow.robot", 11, "workcell.no_such_name"),
        (ABOVE, HAND.replace("quill", "wrist"), "elbow.robot", 12, "workcell.no_body_for_camera"),
    ],
)
def test_a_camera_that_cannot_be_is_told_with_its_line_and_left_out(above, hand, file, line, key):  # R-B07, R-F05
    faults = judged(filmed(above, hand))
    assert [(f.place.file.rpartition("/")[2], f.place.line, f.reason.key) for f in faults] == (
        [(file, line, key)] if key else []
    )


def test_more_cameras_than_there_is_room_for_are_left_out():  # R-B07
    many = "".join(f"CAMERA c{k}\nAT 0 0 {k + 1}\nLOOKS 0 0 0\n" for k in range(10))
    world = FilmedWorld(filmed(many))
    assert sum(bool(sheet.picture) for sheet in world.devices()) == filmed_world.MOST
    assert {fault.reason.key for fault in world.faults} == {"workcell.many_cameras"}
