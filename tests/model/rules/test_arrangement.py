from dataclasses import replace

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.configuration import Configuration, Locus, Placed
from onika.model.preferences import Preferences
from onika.model.rules.arrangement import arranged
from onika.model.rules.box import box_of
from onika.model.task import Task

ARM = Task("arm", "arm", outconst=("NDOF",), invar=("TAU",), outvar=("Q",))
PATH = Task("path", "path", inconst=("NDOF",), invar=("Q",), outvar=("Q_REF",))
SERVO = Task("servo", "servo", inconst=("NDOF",), invar=("Q", "Q_REF"), outvar=("TAU_PD",))
GRAVITY = Task("gravity", "gravity", inconst=("NDOF",), invar=("Q",), outvar=("TAU_G",))
ADD = Task("add", "add", invar=("TAU_PD", "TAU_G"), outvar=("TAU",))
LOOP = (ADD, SERVO, ARM, GRAVITY, PATH)


def made(*tasks: Task) -> tuple[Configuration, dict[str, object]]:
    boxes = {task.name: box_of(task, Preferences()) for task in tasks}
    return Configuration("c", tuple(Placed(task.name) for task in tasks)), boxes


def columns(configuration: Configuration) -> list[list[str]]:
    placed = sorted(configuration.placed, key=lambda each: (each.x, each.y))
    return [[each.task for each in placed if each.x == x] for x in sorted({each.x for each in placed})]


def test_data_flows_from_left_to_right_and_a_loop_goes_back_to_the_hardware() -> None:  # R-C09
    configuration, boxes = made(*LOOP)
    after = arranged(configuration, boxes, ("arm",))
    assert columns(after) == [["arm"], ["gravity", "path"], ["servo"], ["add"]]
    assert {locus.svar for locus in after.loci} == {"NDOF", "Q", "Q_REF", "TAU_PD", "TAU_G", "TAU"}


def test_what_is_arranged_stands_where_it_began_and_the_rest_stays() -> None:
    configuration, boxes = made(*LOOP)
    placed = tuple(replace(each, x=500 + 10 * at, y=300) for at, each in enumerate(configuration.placed))
    before = replace(configuration, placed=placed, loci=(Locus("TAU_G", 7, 7, show=False),))
    after = arranged(before, boxes, (), {"servo", "path"})
    moved = {each.task: (each.x, each.y) for each in after.placed if each not in before.placed}
    assert moved.keys() <= {"servo", "path"}
    assert min(x for x, _ in moved.values()) == 510
    assert Locus("TAU_G", 7, 7, show=False).show is next(each.show for each in after.loci if each.svar == "TAU_G")


def test_lines_that_are_hidden_stay_hidden() -> None:  # R-C09
    configuration, boxes = made(*LOOP)
    after = arranged(replace(configuration, loci=(Locus("Q", show=False),)), boxes)
    assert [each.svar for each in after.loci if not each.show] == ["Q"]


def test_a_task_whose_icon_is_missing_has_its_place_too() -> None:
    configuration = Configuration("c", (Placed("ghost"), Placed("arm")))
    after = arranged(configuration, made(ARM)[1])
    assert len({(each.x, each.y) for each in after.placed}) == 2


def test_nothing_is_arranged_of_nothing() -> None:
    assert arranged(Configuration("c"), {}) == Configuration("c")


svars = st.sampled_from("ABCDEFGH")


@st.composite
def any_tasks(draw: st.DrawFn) -> tuple[Task, ...]:
    return tuple(
        Task(
            f"t{n}",
            f"t{n}",
            invar=tuple(draw(st.sets(svars, max_size=3))),
            outvar=tuple(draw(st.sets(svars, max_size=2))),
        )
        for n in range(draw(st.integers(1, 30)))
    )


@given(any_tasks(), st.booleans())
@settings(max_examples=examples(60), deadline=None)
def test_no_icon_lies_upon_another_and_every_variable_has_a_locus_of_its_own(
    tasks: tuple[Task, ...], has_hardware: bool
) -> None:
    configuration, boxes = made(*tasks)
    after = arranged(configuration, boxes, ("t0",) if has_hardware else ())
    areas = [
        (each.x, each.y, each.x + boxes[each.task].width, each.y + boxes[each.task].height) for each in after.placed
    ]
    for at, (left, top, right, bottom) in enumerate(areas):
        assert all(r <= left or right <= x or b <= top or bottom <= y for x, y, r, b in areas[:at])
    spots = [(each.x, each.y) for each in after.loci]
    assert len(set(spots)) == len(spots)
    assert {each.svar for each in after.loci} == {svar for task in tasks for svar in task.inputs | task.outputs}
    assert arranged(after, boxes, ("t0",) if has_hardware else ()) == after
