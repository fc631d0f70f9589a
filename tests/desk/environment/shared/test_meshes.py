from types import SimpleNamespace

from onika.desk.environment.shared import meshes
from onika.store.mesh_folder import MeshFolder

NAMES = ["a" * 32, "b" * 32]


def subject(*names):
    shapes = [{"mesh": name} for name in (*names, "")]
    return SimpleNamespace(review=SimpleNamespace(worlds=("yard",), shapes=lambda _world: shapes))


def test_meshes_go_with_the_run_as_long_as_there_is_room(tmp_path, monkeypatch):  # R-X21: the 3-D workcell
    folder = MeshFolder(tmp_path)
    folder.keep({NAMES[0]: b"first", NAMES[1]: bytes(range(256)) * 40})
    monkeypatch.setattr(meshes, "made", lambda folder, _site, _world, names: folder.there(names))
    assert [*meshes.meshes(subject(*NAMES), None, folder)] == NAMES
    assert meshes.meshes(subject(NAMES[0]), None, folder) == {NAMES[0]: b"first"}
    monkeypatch.setattr(meshes, "MOST_BYTES", 100)
    assert [*meshes.meshes(subject(*NAMES), None, folder)] == NAMES[:1]


def test_without_a_folder_boxes_stand_for_them():
    assert meshes.meshes(subject(*NAMES), None, None) == {}
    assert meshes.meshes(subject(), None, None) == {}
