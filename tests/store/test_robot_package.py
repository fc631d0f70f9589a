import pytest

from kit.worlds.robot_models import PLAIN
from onika.store.robot_package import package

WITH_PARTS = PLAIN.replace("<worldbody>", '<include file="parts/more.xml"/><worldbody>')


def written(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


def test_a_model_comes_with_all_files_that_it_needs(tmp_path):  # R-X19
    path = written(tmp_path / "theirs" / "plain.xml", WITH_PARTS)
    written(tmp_path / "theirs" / "parts" / "more.xml", "<mujoco/>")
    packed = package(path, "crane", tmp_path / "mine")
    assert packed.file == "crane/plain.xml"
    assert sorted(packed.contents) == ["robot/crane/parts/more.xml", "robot/crane/plain.xml"]
    assert packed.source.find("robot/crane/plain.xml") is not None


def test_a_model_that_lies_in_the_base_directory_stays_there(tmp_path):  # R-X19
    path = written(tmp_path / "robot" / "cranes" / "plain.xml", PLAIN)
    packed = package(path, "crane", tmp_path)
    assert (packed.file, dict(packed.contents)) == ("cranes/plain.xml", {})


def test_a_file_that_is_gone_is_told_and_the_rest_is_packed(tmp_path):  # R-X19
    mesh = '<asset><mesh name="m" file="gone.stl"/></asset><worldbody>'
    packed = package(written(tmp_path / "plain.xml", PLAIN.replace("<worldbody>", mesh)), "crane", tmp_path / "mine")
    assert len(packed.notes) == 1 and "gone.stl" in packed.notes[0].text
    assert packed.lacks == packed.notes


def test_a_repaired_description_stands_beside_its_meshes(tmp_path):  # R-X19
    text = (
        '<robot name="r"><link name="a"><visual><geometry><mesh filename="a.stl"/></geometry></visual>'
        '<visual><geometry><mesh filename="sub/a.stl"/></geometry></visual></link></robot>'
    )
    path = written(tmp_path / "theirs" / "r.urdf", text)
    written(tmp_path / "theirs" / "a.stl", "one")
    written(tmp_path / "theirs" / "sub" / "a.stl", "other")
    packed = package(path, "crane", tmp_path / "mine")
    assert sorted(packed.contents) == ["robot/crane.urdf", "robot/crane/a.stl", "robot/crane/sub/a.stl"]
    assert b'filename="crane/sub/a.stl"' in packed.contents["robot/crane.urdf"]
    assert {file.name for file in packed.origins.values()} == {"a.stl"} and len(packed.origins) == 2


def test_what_cannot_be_read_is_refused(tmp_path):  # R-X19
    with pytest.raises(ValueError, match=r"plain\.xml:1: expected a document in XML"):
        package(written(tmp_path / "plain.xml", "hello"), "crane", tmp_path / "mine")


def test_a_mesh_in_collada_comes_as_one_that_is_read(tmp_path, monkeypatch):  # R-X19
    monkeypatch.setattr("onika.store.collada_mesh.obj_of", lambda _: b"v 0 0 0\n")
    mesh = (
        '<robot name="r"><link name="a"><visual><geometry><mesh filename="a.dae"/></geometry></visual></link></robot>'
    )
    written(tmp_path / "a.dae", "a mesh")
    packed = package(written(tmp_path / "r.urdf", mesh), "r", tmp_path / "mine")
    assert packed.contents["robot/r/a.dae.obj"] == b"v 0 0 0\n"
    assert b'filename="r/a.dae.obj"' in packed.contents["robot/r.urdf"]
    assert packed.notes == ()
