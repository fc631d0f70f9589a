import pytest

from kit.worlds.file_cells import CELL, files_of
from onika.workcell.cell.file_world import FileWorld


def places_of(text):
    return FileWorld(files_of({**CELL, "world/cell.world": text})).button_places()


def test_a_button_stands_at_the_right_hand_of_the_robot_that_it_stops():  # R-K06
    world = CELL["world/cell.world"]
    assert places_of(world) == {"panic": pytest.approx((0.0, -0.3, 0.0, 0.0))}
    second = world.replace("BUTTON", "BUTTON bell\nSTOPS right\n\nBUTTON", 1)
    assert places_of(second)["bell"] == pytest.approx((2.0, 0.3, 0.0, 0.0))  # that place is turned half round


def test_two_buttons_of_one_place_stand_beside_each_other():  # R-K06
    world = CELL["world/cell.world"].replace("BUTTON", "BUTTON bell\nSTOPS left\n\nBUTTON", 1)
    assert {name: place[1] for name, place in places_of(world).items()} == {
        "bell": pytest.approx(-0.3), "panic": pytest.approx(-0.42)}  # fmt: skip


def test_a_button_of_a_place_on_a_part_stands_beside_that_on_a_post():  # R-K06, R-X19
    on = CELL["world/cell.world"].replace("AT 0 0 0 0\n", "AT 0 0 0 0\nON cube.top\n", 1)
    top = FileWorld(files_of())._plant.data.site("cube.top").xpos
    on_table = 0.04  # where the cube lies
    assert places_of(on)["panic"] == pytest.approx((top[0], top[1] - 0.3, top[2], on_table), abs=0.01)


def test_a_post_stands_on_the_floor_where_that_lies_lower_than_the_robot():  # R-K06, R-X19
    low = CELL["world/cell.world"].replace("FLOOR 0", "FLOOR -0.7")
    assert places_of(low) == {"panic": pytest.approx((0.0, -0.3, 0.0, -0.7))}
    none = CELL["world/cell.world"].replace("FLOOR 0\n", "")
    assert places_of(none) == {"panic": pytest.approx((0.0, -0.3, 0.0, 0.0))}


def test_switches_that_a_hand_touches_stand_at_the_left_hand_of_the_first_robot():  # R-K06, R-X19
    world = CELL["world/cell.world"].replace("BUTTON", "SWITCH door\nTOUCHED\n\nSWITCH start\nTOUCHED\n\nBUTTON", 1)
    assert {name: place[1] for name, place in places_of(world).items()} == {
        "panic": pytest.approx(-0.3), "door": pytest.approx(0.3), "start": pytest.approx(0.42)}  # fmt: skip


def test_a_button_stands_beside_what_would_be_around_it():  # R-K06, R-X19
    wide = CELL["robot/elbow.xml"].replace('size="0.08 0.2"', 'size="0.5 0.2"', 1)
    panic = FileWorld(files_of({**CELL, "robot/elbow.xml": wide})).button_places()["panic"]
    assert panic == pytest.approx((0.0, -0.55, 0.0, 0.0))


def test_a_switch_of_a_world_without_robots_stands_on_its_floor():  # R-X19
    world = "VERSION 2.0\nFLOOR -0.1\nPART cube\nFILE cube.xml\nAT 0 0 0 0\nSWITCH start\nTOUCHED\nEOF\n"
    assert places_of(world) == {"start": pytest.approx((0.0, 0.3, -0.1, -0.1))}


def test_which_buttons_are_switches_is_told():  # R-X19
    text = CELL["world/cell.world"].replace("BUTTON", "SWITCH door\nTOUCHED\n\nBUTTON", 1)
    world = FileWorld(files_of({**CELL, "world/cell.world": text}))
    assert world.switches == ("door",)
    assert FileWorld(files_of()).switches == ()
