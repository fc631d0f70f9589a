import pytest

from kit.worlds.robot_models import FAULTS, FAULTY
from onika.store.urdf_repair import repaired

SOUND = """<robot name="r"><link name="a"><visual><geometry><mesh filename="package://r/m/a.stl"/></geometry></visual>
</link></robot>"""


def written(folder, text, name="robot.urdf"):
    path = folder / "urdf" / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
    return path


def test_every_planted_fault_is_repaired_and_told(tmp_path):  # R-X19
    repair = repaired(written(tmp_path, FAULTY))
    assert [note.text for note in repair.notes] == list(FAULTS)


def test_a_mesh_of_a_package_is_looked_for_in_the_folders_above(tmp_path):  # R-X19
    mesh = tmp_path / "m" / "a.stl"
    mesh.parent.mkdir()
    mesh.write_bytes(b"")
    repair = repaired(written(tmp_path, SOUND))
    assert (repair.notes, repair.meshes) == ((), {"package://r/m/a.stl": mesh.resolve()})
    assert b'filename="r/a.stl"' in repair.text({"package://r/m/a.stl": "r/a.stl"})


def test_a_mesh_that_cannot_be_used_is_dropped_with_its_shape(tmp_path):  # R-X19
    mesh = tmp_path / "m" / "a.stl"
    mesh.parent.mkdir()
    mesh.write_bytes(b"")
    repair = repaired(written(tmp_path, SOUND), {mesh.resolve()})
    assert ([note.key for note in repair.notes], repair.meshes) == (["store.urdf_unusable"], {})
    assert b"<visual>" not in repair.text({})


def test_prefixes_and_odd_bytes_are_struck_out(tmp_path):  # R-X19
    prefixed = repaired(written(tmp_path, '<robot name="r"><x:y/><link name="a"/></robot>'))
    odd = repaired(written(tmp_path, '<robot name="r & co"><link name="a\x01"/></robot>'))
    assert [note.key for note in (*prefixed.notes, *odd.notes)] == ["store.urdf_prefixes", "store.urdf_characters"]


@pytest.mark.parametrize("text", ["hello", "", "<html/>", '<!DOCTYPE r [<!ENTITY a "b">]><robot name="&a;"/>'])
def test_what_is_no_robot_is_refused(tmp_path, text):  # R-X19
    with pytest.raises(ValueError, match=r"."):
        repaired(written(tmp_path, text))


def test_a_mesh_in_collada_is_converted(tmp_path, monkeypatch):  # R-X19
    mesh = tmp_path / "m" / "a.dae"
    mesh.parent.mkdir()
    mesh.write_bytes(b"a mesh")
    monkeypatch.setattr("onika.store.collada_mesh.obj_of", lambda content: b"made of " + content)
    repair = repaired(written(tmp_path, SOUND.replace(".stl", ".dae")))
    assert (repair.notes, repair.converted) == ((), {mesh.resolve(): b"made of a mesh"})
    assert repair.meshes == {"package://r/m/a.dae": mesh.resolve()}


def test_a_mesh_in_collada_that_cannot_be_read_is_left_out_and_how_it_could_be_is_told(tmp_path, monkeypatch):  # R-X19
    mesh = tmp_path / "m" / "a.dae"
    mesh.parent.mkdir()
    mesh.write_bytes(b"nonsense")
    path = written(tmp_path, SOUND.replace(".stl", ".dae"))
    broken = repaired(path)
    monkeypatch.setattr("onika.store.collada_mesh.can_read", lambda: False)
    without = repaired(path)
    assert [note.key for note in (*broken.notes, *without.notes)] == ["store.urdf_collada_unread", "store.urdf_collada"]
    assert "pip install 'onika[collada]'" in without.notes[0].text
    assert broken.meshes == without.meshes == {}


def test_links_that_stand_on_each_other_are_named(tmp_path):  # R-X19
    links = "".join(f'<link name="{name}"/>' for name in "abc")
    joints = "".join(
        f'<joint name="{child}j" type="fixed"><parent link="{parent}"/><child link="{child}"/></joint>'
        for parent, child in ("ab", "bc", "cb")
    )
    with pytest.raises(ValueError, match=r"b and c stand on each other|c and b stand on each other"):
        repaired(written(tmp_path, f'<robot name="r">{links}{joints}</robot>'))
