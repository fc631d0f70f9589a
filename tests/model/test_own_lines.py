from dataclasses import replace

from hypothesis import given, strategies as st
from tests.files.models import local_lines, own_lines, tasks

from onika.model.own_lines import NO_OWN_LINES, OwnLines
from onika.model.task import LocalLine, Task

FILED = Task(
    "pd",
    "pd",
    aliases=(("Q", "Q_LEFT"),),
    invar=("Q",),
    outvar=("T",),
    frequency=500.0,
    local=(LocalLine("STIFF", ("1",)), LocalLine("DAMP", ("1",)), LocalLine("STIFF", ("2",))),
)
svars = st.from_regex(r"[A-Z]{1,3}", fullmatch=True)


@given(filed=tasks(), data=st.data())
def test_what_makes_a_task_of_another_makes_it_again(filed: Task, data: st.DataObject) -> None:
    pairs = {pin: data.draw(svars) for pin in filed.kinds() if data.draw(st.booleans())}  # R-B09
    aliases = tuple((pin, svar) for pin, svar in pairs.items() if pin != svar)
    local = tuple(data.draw(st.lists(local_lines, unique_by=lambda line: line.key, max_size=4)))
    wished = replace(filed, aliases=aliases, local=local)
    made = OwnLines.between(filed, wished).on(filed)
    assert {pin: svar for pin, svar in made.aliases if pin != svar} == dict(wished.aliases)
    assert set(made.local) == set(wished.local)
    assert OwnLines.between(filed, made) == OwnLines.between(filed, wished)


@given(filed=tasks(), own=own_lines())
def test_lines_change_aliases_and_parameters_alone(filed: Task, own: OwnLines) -> None:
    made = own.on(filed)
    assert replace(made, aliases=filed.aliases, local=filed.local) == filed


@given(filed=tasks())
def test_a_task_as_its_file_says_has_no_lines_of_its_own(filed: Task) -> None:
    assert OwnLines.between(filed, filed) == NO_OWN_LINES
    assert NO_OWN_LINES.on(filed) is filed


def test_a_parameter_that_stands_twice_in_the_file_is_replaced_once() -> None:
    made = OwnLines(local=(LocalLine("STIFF", ("0.5",)), LocalLine("NEW", ()))).on(FILED)
    assert made.local == (LocalLine("STIFF", ("0.5",)), LocalLine("DAMP", ("1",)), LocalLine("NEW", ()))


def test_a_parameter_can_be_left_out_and_an_alias_taken_away() -> None:
    made = OwnLines((("Q", "Q"), ("T", "TAU")), (), ("STIFF",)).on(FILED)
    assert made.aliases == (("T", "TAU"),)
    assert made.local == (LocalLine("DAMP", ("1",)),)


def test_an_alias_of_a_pin_that_the_file_lacks_says_nothing() -> None:
    assert OwnLines((("GONE", "X"),)).on(FILED).aliases == FILED.aliases
