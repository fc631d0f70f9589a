"""Names and aliases."""

import pytest

from onika.words.name import SVAR_NAME, TASK_NAME, resolve


@pytest.mark.parametrize("name", ["Q", "Q_REF", "Q^_REF", "X^^_MEZ", "TAU1"])
def test_a_state_variable_is_capitals_digits_underscores_and_derivatives(name):  # law 8
    assert SVAR_NAME.match(name)


@pytest.mark.parametrize("name", ["", "q_ref", "1Q", "_Q", "^Q", "Q-REF", "Q REF", "Q_REF\n", "QÄ"])
def test_other_names_are_no_state_variables(name):  # law 8
    assert not SVAR_NAME.match(name)


@pytest.mark.parametrize("name", ["jtraj", "box1_aj", "puma.kin", "a-b", "a" * 200])
def test_a_task_name_is_a_file_name(name):
    assert TASK_NAME.match(name)


@pytest.mark.parametrize("name", ["", "../x", "a/b", ".hidden", "a b", "1st", "a\n", "a" * 201])
def test_a_task_name_leads_nowhere_else(name):
    assert not TASK_NAME.match(name)


def test_aliases_are_resolved_once_so_that_two_names_can_be_swapped():  # R-C04
    assert resolve(("A", "B", "C"), {"A": "B", "B": "A"}) == ("B", "A", "C")
    assert resolve(("A",), {"A": "B", "B": "C"}) == ("B",)
