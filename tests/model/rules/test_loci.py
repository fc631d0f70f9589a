from dataclasses import replace

from hypothesis import given, strategies as st

from onika.model.configuration import Configuration, Placed
from onika.model.preferences import Preferences
from onika.model.rules.box import box_of
from onika.model.rules.loci import flipped, settled
from onika.model.task import Task

WRITER = Task("writer", "w", outvar=("Q",))
READER = Task("reader", "r", invar=("Q",))
THIRD = Task("third", "t", invar=("Q",))
BOXES = {task.name: box_of(task, Preferences()) for task in (WRITER, READER, THIRD)}
NOTHING = Configuration("c")


def with_placed(former, *placed):
    return settled(replace(former, placed=placed), BOXES, former)


def spot(configuration, svar="Q"):
    return next((locus.x, locus.y) for locus in configuration.loci if locus.svar == svar)


def pin(placed):
    box = BOXES[placed.task]
    return box.reach(box.pins[0], placed.x, placed.y, placed.in_left)


A = Placed("writer", 0, 0)
B = Placed("reader", 600, 200)
C = Placed("third", 1200, 0)


def test_a_locus_is_born_a_few_pixels_outside_its_first_pin():  # R-C24
    item = with_placed(NOTHING, A)
    assert 0 < spot(item)[0] - pin(A)[0] < 60
    assert spot(item)[1] == pin(A)[1]


def test_the_second_task_brings_it_half_way():  # R-C24
    two = with_placed(with_placed(NOTHING, A), A, B)
    (ax, ay), (bx, by) = pin(A), pin(B)
    assert spot(two) == ((ax + bx) // 2, (ay + by) // 2)
    assert two.loci[0].conns == 2


def test_later_tasks_do_not_move_it():  # R-C24
    two = with_placed(with_placed(NOTHING, A), A, B)
    three = with_placed(two, A, B, C)
    assert spot(three) == spot(two)
    assert three.loci[0].conns == 3
    assert spot(with_placed(three, A, C)) == spot(two)


def test_back_to_one_task_it_goes_beside_that_pin():  # R-C24
    two = with_placed(with_placed(NOTHING, A), A, B)
    item = with_placed(two, B)
    assert spot(item)[1] == pin(B)[1]
    assert 0 < pin(B)[0] - spot(item)[0] < 60


def test_with_the_last_task_it_is_gone():  # R-C24
    assert with_placed(with_placed(NOTHING, A)).loci == ()


def test_it_stays_when_its_tasks_move():  # R-C24
    two = with_placed(with_placed(NOTHING, A), A, B)
    assert spot(with_placed(two, replace(A, x=300, y=300), B)) == spot(two)


def test_only_a_locus_of_a_single_task_follows_a_flip():  # R-C24
    turned = replace(A, in_left=False)
    item = flipped(replace(with_placed(NOTHING, A), placed=(turned,)), ("writer",), BOXES)
    assert spot(item)[0] < 0
    two = with_placed(with_placed(NOTHING, A), A, B)
    assert spot(flipped(replace(two, placed=(turned, B)), ("writer",), BOXES)) == spot(two)


def test_it_is_kept_off_icons():  # R-C24
    between = Placed("third", 300, 60)
    result = with_placed(with_placed(NOTHING, A, between), A, between, B)
    x, y = spot(result)
    box = BOXES["third"]
    assert not (between.x <= x <= between.x + box.width and between.y <= y <= between.y + box.height)


def test_the_loci_of_a_task_that_no_library_knows_are_kept():
    stranger = Placed("stranger", 0, 0)
    before = with_placed(NOTHING, A)
    kept = settled(replace(before, placed=(stranger,)), BOXES, replace(before, placed=(stranger,)))
    assert kept.loci == before.loci


spots = st.tuples(st.integers(-500, 1500), st.integers(-500, 1500), st.booleans())


@given(st.lists(st.tuples(st.sampled_from(["writer", "reader", "third"]), spots), max_size=12))
def test_there_is_one_locus_for_each_variable_used_and_none_else(changes):  # R-C09, R-C24
    now = NOTHING
    for name, (x, y, in_left) in changes:
        others = tuple(item for item in now.placed if item.task != name)
        stands = len(others) < len(now.placed)
        now = with_placed(now, *others, *(() if stands else (Placed(name, x, y, in_left),)))
        assert [locus.svar for locus in now.loci] == (["Q"] if now.placed else [])
        assert all(locus.conns == len(now.placed) for locus in now.loci)


MANY = (WRITER, READER, THIRD, Task("both", "b", inconst=("P",), invar=("P", "Q"), outvar=("R",)))
RENAMED = (*MANY[:3], replace(MANY[3], aliases=(("R", "S"), ("P", "Q"))))
FIRST = {task.name: box_of(task, Preferences()) for task in MANY}
SECOND = {task.name: box_of(task, Preferences()) for task in RENAMED}
names = st.lists(st.sampled_from([*FIRST, "stranger"]), unique=True)


def users(names, boxes):
    result = {}
    for name in names:
        for pin in boxes[name].pins if name in boxes else ():
            result.setdefault(pin.svar, []).append((name, pin))
    return result


@given(st.lists(st.tuples(names, st.sampled_from([FIRST, SECOND])), max_size=6))
def test_loci_are_where_the_plain_definition_says(states):  # R-C24
    now, former_boxes = NOTHING, FIRST
    for placed, boxes in states:
        spread = tuple(Placed(name, 400 * place, 90 * place) for place, name in enumerate(placed))
        result = settled(replace(now, placed=spread), boxes, now, former_boxes)
        here, before = users(placed, boxes), users([item.task for item in now.placed], former_boxes)
        old, new = ({locus.svar: locus for locus in each.loci} for each in (now, result))
        kept = {svar for svar in old if "stranger" in placed}
        assert set(new) == set(here) | kept
        for svar, pins in here.items():
            count, was = len({name for name, _ in pins}), len({name for name, _ in before.get(svar, ())})
            stays = svar in old and not (count >= 2 and was == 1) and not (count == 1 and was > 1)
            assert not stays or (new[svar].x, new[svar].y) == (old[svar].x, old[svar].y)
            assert new[svar].conns == count
            assert new[svar].invar + new[svar].outvar + new[svar].inconst + new[svar].double_in == len(pins)
        now, former_boxes = result, boxes
