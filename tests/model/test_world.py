"""A world as its file says."""

from onika.model.world import ButtonBlock, LampBlock, PartBlock, PlaceBlock, SwitchBlock, WorldText


def test_the_blocks_of_a_world_are_found_by_their_kind():  # R-X19
    part, switch, lamp = PartBlock("table", "t.xml"), SwitchBlock("on", None, ("pad", 1.0)), LampBlock("lamp", ("on",))
    left, right, button = PlaceBlock("left", ("a", "b")), PlaceBlock("right", ("b",)), ButtonBlock("stop", ("left",))
    world = WorldText("w", blocks=(part, left, switch, lamp, right, button))
    assert (world.parts, world.places, world.switches) == ((part,), (left, right), (switch,))
    assert (world.lamps, world.buttons, world.robots) == ((lamp,), (button,), ("a", "b"))
