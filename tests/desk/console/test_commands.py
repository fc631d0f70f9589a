import re

import pytest

from onika.desk.console import commands

ALL = [*commands.TASKS, *commands.CHANGES, *commands.LOOKS, *commands.WHOLE]


@pytest.mark.parametrize("one", ALL, ids=lambda one: one.name)
def test_a_command_is_written_as_its_name_says_and_explained_in_a_line(one):  # R-A16
    assert re.split(r"\W", one.usage)[0] == one.name
    assert 0 < len(one.summary) < 80
    assert not one.summary.endswith(".")
    assert all(len(line) < 110 for line in one.text.splitlines())


def test_names_are_there_once():
    names = [one.name for one in ALL]
    assert len(names) == len(set(names))


def test_echo_says_its_line(sit):
    assert sit().does("echo  a  b  # c", "echo") == ["a  b", ""]
