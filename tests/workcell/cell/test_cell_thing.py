"""What can touch in a world that is files."""

from kit.worlds.box_cells import boxes_world
from kit.worlds.file_cells import files_of
from onika.words.reason import Reason, in_language
from onika.workcell.cell.cell_thing import called, called_arm, called_hand, called_part, rank, things_of
from onika.workcell.cell.file_world import FileWorld


def test_every_shape_belongs_to_an_arm_a_hand_a_part_or_the_floor():  # R-E16, R-X19
    world = FileWorld(files_of())
    model = world._plant.model
    things = list(things_of(model, world._composition.world, world._stands.arms()))
    assert len(things) == model.ngeom
    left = [thing for thing in things if thing.name == "left"]
    assert {thing.kind for thing in left} == {"arm", "hand"} and {thing.arm for thing in left} == {"elbow_left"}
    assert {(thing.kind, thing.name) for thing in things if not thing.moves} == {
        ("floor", ""), ("fixed", "left."), ("fixed", "right."), ("fixed", "table"), ("free", "cube"),
    }  # fmt: skip


def test_each_is_called_by_what_people_know_of_it():  # R-X19
    world = FileWorld(files_of())
    text, arms = world._composition.world, world._stands.arms()
    things = sorted(set(things_of(world._plant.model, text, arms)), key=rank)
    names = [str(thing.text) for thing in things if "right" not in thing.name]
    assert names == ["the hand of elbow_left", "elbow_left", "cube", "elbow_left", "table", "the floor"]


def test_what_has_names_is_called_by_them_in_each_language():  # R-X19
    world = boxes_world()
    world.claim("arm_left", 1)
    (arm,) = world._stands.arms()
    text = world._composition.world
    box = called_part(text, "box_waves")
    assert (str(box), in_language(box, "es")) == ("the box with the waves", "la caja con las ondas")
    alone = [call(text, arm, is_alone=True) for call in (called_arm, called_hand)]
    assert list(map(str, alone)) == ["the arm", "the hand"]
    beside = [call(text, arm, is_alone=False) for call in (called_arm, called_hand)]
    assert list(map(str, beside)) == ["the left arm", "the left hand"]
    assert str(called((("es", "la mesa"),), Reason.plain("table"))) == "la mesa"
