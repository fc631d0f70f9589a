import pytest

from onika.desk.environment.habits import NAME, Habits, keep, read
from onika.words.fault import Refusal


def test_habits_are_kept_in_the_state_directory(tmp_path):  # R-C20
    state = tmp_path / "a" / "state"
    assert read(state, {}) == (Habits(), "")
    assert keep(state, Habits(shows_warnings=False)) is None
    assert read(state, {}) == (Habits(shows_warnings=False), "")


def test_without_a_state_directory_they_hold_for_the_session(tmp_path):
    assert keep(None, Habits(keeps_diary=False)) is None
    assert read(None, {}) == (Habits(), "")


@pytest.mark.parametrize(("value", "shown"), [("1", True), ("yes", True), ("", False), ("0", False), ("NO", False)])
def test_the_environment_rules_over_the_file(tmp_path, value, shown):  # R-C20
    keep(tmp_path, Habits(shows_warnings=not shown))
    assert read(tmp_path, {"ONIKA_WARNINGS": value})[0].shows_warnings is shown


@pytest.mark.parametrize("content", [b"{", b'{"shows_warnings": 3}', b"\xff"])
def test_a_file_that_cannot_be_read_is_named_and_the_defaults_hold(tmp_path, content):  # R-B07
    (tmp_path / NAME).write_bytes(content)
    habits, wrong = read(tmp_path, {})
    assert habits == Habits()
    assert str(tmp_path / NAME) in wrong


def test_where_they_cannot_be_written_the_reason_is_given(tmp_path):
    (tmp_path / "state").write_text("")
    assert isinstance(keep(tmp_path / "state", Habits()), Refusal)
