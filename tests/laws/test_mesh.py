import numpy as np
import pytest

from onika.laws.mesh import encoded, mesh_name, thinned


def ball(rows):
    """A closed surface about the middle, with two triangles for each field of a net of so many rows."""
    up, round_ = np.meshgrid(np.linspace(-1.4, 1.4, rows), np.linspace(0.0, 2.0 * np.pi, rows), indexing="ij")
    places = np.stack([np.cos(up) * np.cos(round_), np.cos(up) * np.sin(round_), np.sin(up)], axis=-1).reshape(-1, 3)
    fields = [(r * rows + c) for r in range(rows - 1) for c in range(rows - 1)]
    halves = [((k, k + 1, k + rows), (k + 1, k + rows + 1, k + rows)) for k in fields]
    return places, np.array(halves).reshape(-1, 3)


def test_a_fine_mesh_becomes_one_of_few_triangles_that_lies_near_it():  # R-X19
    places, triangles = ball(120)
    few, left = thinned(places, triangles)
    assert 500 < len(left) <= 1500 < len(triangles)
    assert np.abs(np.linalg.norm(few, axis=1) - 1.0).max() < 0.02
    assert left.max() < len(few)
    looks = np.cross(few[left[:, 1]] - few[left[:, 0]], few[left[:, 2]] - few[left[:, 0]])
    inwards = (looks * few[left].mean(axis=1)).sum(axis=1)
    assert min((inwards > 0).mean(), (inwards < 0).mean()) < 0.02  # all look the same way, as before


def test_a_mesh_of_few_triangles_stays_as_it_is():  # R-X19
    places, triangles = ball(8)
    few, left = thinned(places, triangles)
    assert few is places and left is triangles


@pytest.mark.parametrize("count", [0, 2000])
def test_a_mesh_without_size_does_no_harm(count):  # R-X19
    places, triangles = np.zeros((count, 3)), np.zeros((count, 3), dtype=np.int64)
    assert len(thinned(places, triangles)[1]) == count


def test_corners_come_back_from_the_bytes_to_a_part_of_their_box():  # R-X19
    places, triangles = ball(20)
    middle, half = np.array([0.5, 0.0, 0.0]), np.array([2.0, 1.0, 1.0])
    content = encoded(places, triangles, middle, half)
    corners, count = np.frombuffer(content, "<u4", 2)
    assert (corners, count) == (len(places), len(triangles))
    shares = np.frombuffer(content, "<u2", 3 * corners, 8).reshape(-1, 3)
    back = middle + (shares / 65535.0 * 2.0 - 1.0) * half
    assert np.abs(back - places).max() < 2.0 * half.max() / 65535
    assert (np.frombuffer(content, "<u2", 3 * count, 8 + 6 * corners).reshape(-1, 3) == triangles).all()


def test_more_corners_than_can_be_counted_are_refused():  # R-X19
    with pytest.raises(ValueError, match="65535"):
        encoded(np.zeros((65536, 3)), np.zeros((0, 3), dtype=np.int64), np.zeros(3), np.ones(3))


def test_a_name_tells_meshes_apart():  # R-X19
    places, triangles = (part.astype(kind) for part, kind in zip(ball(8), (np.float32, np.int32), strict=True))
    name = mesh_name(places, triangles)
    moved = places.copy()
    moved[3, 1] += 1e-4
    assert name == mesh_name(places.copy(), triangles.copy())
    assert len({name, mesh_name(moved, triangles), mesh_name(places, triangles[::-1])}) == 3
    assert len(name) == 32
