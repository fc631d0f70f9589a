"""What can touch in a world that is files."""

from kit.worlds.file_cells import files_of
from onika.workcell.cell.cell_thing import CellThing, rank, things_of
from onika.workcell.cell.file_world import FileWorld


def test_every_shape_belongs_to_an_arm_a_hand_a_part_or_the_floor():  # R-E16, R-X19
    world = FileWorld(files_of())
    model = world._plant.model
    things = list(things_of(model, world._composition.world, world._stands.arms()))
    assert len(things) == model.ngeom
    left = [thing for thing in things if thing.name == "left"]
    assert {thing.kind for thing in left} == {"arm", "hand"} and {thing.arm for thing in left} == {"elbow_left"}
    assert {(thing.kind, thing.name) for thing in things if not thing.moves} == {
        ("floor", ""), ("fixed", ""), ("fixed", "table"), ("free", "cube"),
    }  # fmt: skip


def test_each_is_called_by_what_people_know_of_it():
    arm, hand = CellThing("arm", "left", "elbow_left"), CellThing("hand", "left", "elbow_left")
    names = [
        str(thing.text) for thing in (hand, arm, CellThing("free", "cube"), CellThing("floor"), CellThing("fixed"))
    ]
    assert names == ["the hand of elbow_left", "elbow_left", "cube", "the floor", "what stands around it"]
    assert sorted([CellThing("floor"), CellThing("free", "cube"), arm, hand], key=rank)[:2] == [hand, arm]
