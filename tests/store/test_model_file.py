"""Models made to stand alone: what they need is called by its content."""

import pytest

from onika.store.model_file import self_contained

MODEL = """<mujoco>
  <compiler meshdir="meshes" texturedir="paint"/>
  <include file="common.xml"/>
  <asset>
    <mesh file="sub/link.obj"/>
    <mesh name="own"
          file="other.obj"/>
    <mesh file="gone.obj"/>
    <texture name="wood" type="2d" file="wood.png"/>
  </asset>
</mujoco>
"""


@pytest.fixture
def folder(tmp_path):
    for name in ("meshes/sub/link.obj", "meshes/other.obj", "paint/wood.png"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    (tmp_path / "common.xml").write_text("<mujoco/>")
    (tmp_path / "arm.xml").write_text(MODEL)
    return tmp_path


def test_every_file_is_called_by_its_content_and_lines_stay_where_they_are(folder):  # R-X19
    content, needed, _ = self_contained(folder / "arm.xml")
    text = content.decode()
    assert {file.path.name for file in needed} == {"link.obj", "other.obj", "wood.png", "common.xml"}
    assert all(file.name in text for file in needed)
    assert 'meshdir=""' in text
    assert text.splitlines()[4].strip().startswith('<mesh name="link" file="')
    assert len(text.splitlines()) == len(MODEL.splitlines())


def test_a_file_that_is_gone_is_told_with_its_line_and_the_rest_stays(folder):  # R-B07, R-X19
    content, _, (fault,) = self_contained(folder / "arm.xml")
    assert (fault.place.file, fault.place.line) == (str(folder / "arm.xml"), 8)
    assert fault.reason.key == "store.model_file_gone"
    assert b'name="gone" file="missing.obj"' in content


def test_two_files_of_one_name_and_other_content_are_two(folder):
    (folder / "arm.xml").write_text(MODEL.replace("other.obj", "link.obj"))
    (folder / "meshes" / "link.obj").write_text("another")
    _, needed, _ = self_contained(folder / "arm.xml")
    assert len({file.name for file in needed if file.path.name == "link.obj"}) == 2


def test_a_mesh_of_a_package_is_looked_for_above_its_description(tmp_path):
    (tmp_path / "robots" / "urdf").mkdir(parents=True)
    (tmp_path / "robots" / "meshes").mkdir()
    (tmp_path / "robots" / "meshes" / "a.stl").write_text("solid")
    urdf = tmp_path / "robots" / "urdf" / "a.urdf"
    urdf.write_text('<robot name="a"><link name="b"><mesh filename="package://robots/meshes/a.stl"/></link></robot>')
    content, (mesh,), faults = self_contained(urdf)
    assert (mesh.path.name, faults) == ("a.stl", ())
    assert mesh.name.encode() in content


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ("<mujoco>", "store.no_xml"),
        ("", "store.no_xml"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><mujoco/>', "plain"),
        ('<mujoco><include file="arm.xml"/></mujoco>', "store.includes_itself"),
    ],
)
def test_what_is_no_model_is_told(tmp_path, text, key):  # R-B07
    (tmp_path / "arm.xml").write_text(text)
    _, _, faults = self_contained(tmp_path / "arm.xml")
    assert key in [fault.reason.key for fault in faults]


def test_what_is_said_last_of_folders_counts_for_all_that_is_included(tmp_path):  # R-X19
    (tmp_path / "parts" / "meshes").mkdir(parents=True)
    (tmp_path / "parts" / "meshes" / "link.obj").write_text("link")
    included = '<mujoco><compiler meshdir="meshes"/><asset><mesh file="link.obj"/></asset></mujoco>'
    (tmp_path / "parts" / "arm.xml").write_text(included)
    last = '<compiler meshdir="parts/meshes"/><compiler angle="radian"/>'
    (tmp_path / "cell.xml").write_text(f'<mujoco><include file="parts/arm.xml"/>{last}</mujoco>')
    _, needed, faults = self_contained(tmp_path / "cell.xml")
    assert (faults, {file.path.name for file in needed}) == ((), {"link.obj", "arm.xml"})


@pytest.fixture
def collada(tmp_path):
    """A model with one mesh in COLLADA."""
    (tmp_path / "arm.dae").write_text("<COLLADA/>")
    path = tmp_path / "arm.xml"
    path.write_text('<mujoco><asset>\n<mesh file="arm.dae"/></asset></mujoco>')
    return path


def test_a_mesh_in_collada_becomes_one_that_mujoco_reads(collada, monkeypatch):  # R-X19
    monkeypatch.setattr("onika.store.collada_mesh.obj_of", lambda content: b"obj of " + content)
    content, (mesh,), faults = self_contained(collada)
    assert (mesh.content, mesh.name[-4:], faults) == (b"obj of <COLLADA/>", ".obj", ())
    assert f'file="{mesh.name}"'.encode() in content


@pytest.mark.parametrize(
    ("file", "is_installed", "key"),
    [
        ("arm.dae", False, "store.collada_extra"),
        ("arm.dae", True, "store.collada_empty"),
        ("arm.glb", True, "store.mesh_kind"),
    ],
)
def test_a_mesh_that_mujoco_does_not_read_is_told_with_its_line_and_what_helps(
    collada, monkeypatch, file, is_installed, key
):  # R-B07, R-X19
    monkeypatch.setattr("onika.store.collada_mesh.can_read", lambda: is_installed)
    (collada.parent / "arm.glb").write_text("glTF")
    collada.write_text(collada.read_text().replace("arm.dae", file))
    content, needed, (fault,) = self_contained(collada)
    assert (fault.reason.key, fault.place.line, needed) == (key, 2, ())
    assert b'file="missing.obj"' in content
