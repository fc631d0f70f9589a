import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.button_commands import Commands
from onika.files import buttons as file
from onika.model.button import Button
from onika.wire import act, view
from onika.words.fault import Refusal
from onika.words.reason import Reason


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path)


def kept(sitting):
    return sitting.site.buttons()[0]


def has_ended(button):
    return button.code is not None


def test_a_button_is_added_changed_and_removed_in_the_users_file(sitting):  # R-G02
    sitting.do(act.SetButton(" make  tea ", "echo tea", spawns_terminal=True))
    sitting.do(act.SetButton("Home", "onika run go_home"))
    sitting.do(act.SetButton("make tea", "echo coffee &"))
    assert kept(sitting) == (Button("make tea", "echo coffee &"), Button("Home", "onika run go_home"))
    shown = sitting.environment.tree.buttons
    assert [(name, button.order, button.command) for name, button in shown.items()] == [
        ("make tea", 0, "echo coffee &"),
        ("Home", 1, "onika run go_home"),
    ]
    sitting.do(act.SetButton("make tea", ""))
    assert kept(sitting) == (Button("Home", "onika run go_home"),)
    assert list(sitting.environment.tree.buttons) == ["Home"]


def test_comments_of_the_file_stay(sitting):  # R-B01
    sitting.home.mkdir()
    path = sitting.home / file.NAME
    path.write_text("# my buttons\n" + file.write((Button("a", "true"),)))
    sitting.do(act.SetButton("b", "false"))
    assert "# my buttons" in path.read_text()
    assert [button.name for button in kept(sitting)] == ["a", "b"]


@pytest.mark.parametrize(
    ("name", "command", "field"),
    [("", "true", "name"), ("a\x07b", "true", "name"), ("a", "true\nfalse", "command"), ("a", "x\x1b[2J", "command")],
)
def test_what_a_file_cannot_say_again_is_refused(sitting, name, command, field):  # R-G02, R-B07
    assert list(sitting.no(act.SetButton(name, command)).fields) == [field]
    assert kept(sitting) == ()


def test_a_file_with_faults_is_left_as_it_is(sitting):  # R-B07
    sitting.home.mkdir()
    path = sitting.home / file.NAME
    path.write_text("BUTTON a\nEOF\n")
    assert "left as it is" in str(sitting.no(act.SetButton("b", "true")).reason)
    assert path.read_text() == "BUTTON a\nEOF\n"


def test_where_the_file_cannot_be_written_there_is_no_button(sitting):  # R-G02
    sitting.home.write_text("no directory")
    assert "cannot be saved" in str(sitting.no(act.SetButton("b", "true")).reason)


def test_a_pressed_button_shows_what_its_command_prints_and_how_it_ends(sitting):  # R-G02
    sitting.do(act.SetButton("Try", "echo here; exit 3"))
    sitting.do(act.Press("Try"))
    assert sitting.environment.tree.buttons["Try"].is_running
    ended = sitting.button("Try", has_ended)
    assert (ended.output, ended.code, ended.is_running) == ("here\n", 3, False)
    sitting.do(act.Press("Try"))
    again = sitting.environment.tree.buttons["Try"]
    assert (again.output, again.code, again.is_running) == ("", None, True)
    sitting.button("Try", has_ended)


def test_a_running_command_is_halted_and_neither_started_twice_nor_removed(sitting):  # R-G02
    sitting.do(act.SetButton("Wait", "sleep 1000"))
    assert "not running" in str(sitting.no(act.Halt("Wait")).reason)
    sitting.do(act.Press("Wait"))
    assert [remedy.act for remedy in sitting.no(act.Press("Wait")).remedies] == [act.Halt("Wait")]
    assert "is running" in str(sitting.no(act.SetButton("Wait", "")).reason)
    sitting.do(act.Halt("Wait"))
    assert sitting.button("Wait", has_ended).code == -15


def test_only_what_stands_in_the_users_file_is_ever_run(sitting):  # R-G02
    assert "there is no button" in str(sitting.no(act.Press("rm -rf /")).reason)


def test_a_button_that_is_gone_shows_nothing_any_more(sitting):  # R-G02
    sitting.do(act.SetButton("a", "true"))
    sitting.do(act.Press("a"))
    sitting.button("a", has_ended)
    sitting.do(act.SetButton("a", ""))
    sitting.do(act.SetButton("a", "false"))
    assert sitting.environment.tree.buttons["a"] == view.ButtonView("false", 0)


class Refusing(Commands):
    """Commands of which none can begin."""

    def start(self, button):
        return Refusal(Reason.plain("no more processes"))


def test_a_command_that_cannot_begin_is_refused(tmp_path):  # R-G02
    sitting = EnvironmentFixture(tmp_path)
    sitting.do(act.SetButton("a", "true"))
    sitting.surroundings.commands.__class__ = Refusing
    assert str(sitting.no(act.Press("a")).reason) == "a cannot be run: no more processes"
