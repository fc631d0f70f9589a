import pytest

from onika.desk.console import commands
from onika.words.reason import in_language
from onika.words.sentence import LANGUAGES

ALL = [*commands.TASKS, *commands.CHANGES, *commands.LOOKS, *commands.FLOWS, *commands.WHOLE]


@pytest.mark.parametrize("command", ALL, ids=lambda command: command.name)
def test_a_command_is_written_as_its_name_says_and_explained_in_a_line(command):  # R-A16
    assert command.usage.split()[0] == command.name
    for language in LANGUAGES:
        purpose, more = in_language(command.purpose, language), in_language(command.more, language)
        assert 0 < len(purpose) < 80
        assert not purpose.endswith(".")
        assert all(len(line) < 110 for line in more.splitlines())


def test_names_are_there_once():
    names = [command.name for command in ALL]
    assert len(names) == len(set(names))


def test_echo_says_its_line(sit):
    assert sit().does("echo  a  b  # c", "echo") == ["a  b", ""]
