import numpy as np

from kit.desk.review_fixture import LAMP
from onika.desk.environment.shared.blocks import Blocks
from onika.desk.environment.shared.grid import grid
from onika.desk.environment.shared.worlds import worlds


def test_bodies_are_where_they_were_and_shine_when_they_did(watched):  # R-X21: the 3-D workcell
    blocks, instants = Blocks(), grid(watched.subject.view, 0.5)
    yard = worlds(watched.subject, instants, blocks)["yard"]
    assert [shape["name"] for shape in yard["shapes"]] == [LAMP["name"]]
    assert [(place, lit) for place, lit in yard["lit"]] == [(0, []), (instants.tolist().index(1_000_000_000), ["lamp"])]
    (stretch,) = yard["stretches"]
    place = blocks.places[stretch["poses"]]
    assert (stretch["first"], place["rows"], place["columns"]) == (0, 14, len(instants))


def test_places_are_those_of_the_recording(watched):  # R-X21: 50 instants equal the recording
    instants = grid(watched.subject.view, 1.0)
    for at in instants.tolist():
        rows = np.array(watched.subject.review.poses("yard", at * 1e-9), dtype=np.float32)
        assert rows[1][0] == min(at // 1_000_000_000, 2)
