import sys

import pytest

from onika.store.collada_mesh import can_read, obj_of

TRIANGLE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="inch" meter="{unit}"/><up_axis>Y_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="pa" count="12">0 0 0  2 0 0  0 4 0  0 0 6</float_array>
      <technique_common><accessor source="#pa" count="4" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    {primitive}
  </mesh></geometry></library_geometries>
  {scene}
</COLLADA>"""
TRIANGLES = '<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2 0 2 3</p></triangles>'
LINES = '<lines count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1</p></lines>'
SQUARE = (
    '<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist>'
)
PLACED = """<library_visual_scenes><visual_scene id="s"><node id="n"><translate>10 0 0</translate>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>"""


def document(primitive=TRIANGLES, scene=PLACED, unit="1"):
    return TRIANGLE.format(primitive=primitive, scene=scene, unit=unit).encode()


def read(content):
    rows = [row.split() for row in obj_of(content).decode().splitlines()]
    corners = [tuple(map(float, row[1:])) for row in rows if row[0] == "v"]
    return {tuple(corners[int(number) - 1] for number in row[1:]) for row in rows if row[0] == "f"}


def test_triangles_stand_where_the_scene_places_them_whatever_is_up():  # R-X19
    assert read(document()) == {((10, 0, 0), (12, 0, 0), (10, 4, 0)), ((10, 0, 0), (10, 4, 0), (10, 0, 6))}


def test_without_a_scene_they_stand_where_they_were_made_and_lengths_become_metres():  # R-X19
    assert read(document(scene="", unit="0.5")) == {
        ((0, 0, 0), (1, 0, 0), (0, 2, 0)),
        ((0, 0, 0), (0, 2, 0), (0, 0, 3)),
    }


def test_what_has_four_corners_becomes_triangles():  # R-X19
    assert len(read(document(SQUARE))) == 2


@pytest.mark.parametrize("content", [b"", b"hello", b"<COLLADA/>", document(LINES), document()[:-300]])
def test_what_has_no_triangles_is_told(content):  # R-X19
    with pytest.raises(ValueError, match="COLLADA"):
        obj_of(content)


def test_whether_the_library_is_there_is_known_without_loading_it(monkeypatch):  # R-X19
    assert can_read()
    monkeypatch.setitem(sys.modules, "collada", None)
    monkeypatch.setattr("onika.store.collada_mesh.find_spec", lambda _: None)
    assert not can_read()
