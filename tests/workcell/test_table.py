import mujoco
import pytest

from onika.workcell.arm import SHOULDER_M
from onika.workcell.paint import paints
from onika.workcell.part import document
from onika.workcell.table import TOP_M, floor, table, top_at


def test_the_tables_top_and_the_floor_are_where_they_are_said_to_be():
    model = mujoco.MjModel.from_xml_string(document("table", [floor(False), table(False)]))
    top = model.geom("table")
    assert top.pos[2] + top.size[2] == pytest.approx(TOP_M)
    assert (2 * top.size[:2]).tolist() == pytest.approx([0.7, 1.0])
    assert model.geom("floor").pos[2] == pytest.approx(-SHOULDER_M)


def test_a_drawn_table_stands_on_the_drawn_floor():
    model = mujoco.MjModel.from_xml_string(document("table", [paints(), floor(True), table(True)]))
    lowest = min(
        model.geom_pos[k, 2] - model.geom_size[k, 2] for k in range(model.ngeom) if model.geom(k).name != "floor"
    )
    assert lowest == pytest.approx(-SHOULDER_M)


@pytest.mark.parametrize(
    ("place", "height"), [((0.7, 0.0), TOP_M), ((0.2, 0.0), -SHOULDER_M), ((0.7, 0.6), -SHOULDER_M)]
)
def test_beside_the_table_is_the_floor(place, height):
    assert top_at(*place) == height
