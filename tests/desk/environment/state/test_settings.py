import pytest

from onika.desk.environment.state.settings import NAME, Settings, keep, read
from onika.words.fault import Refusal
from onika.words.reason import NOTHING


def test_habits_are_kept_in_the_state_directory(tmp_path):  # R-C20
    state = tmp_path / "a" / "state"
    assert read(state, {}) == (Settings(), NOTHING)
    assert keep(state, {"shows_warnings": False}) is None
    assert read(state, {}) == (Settings(shows_warnings=False), NOTHING)


def test_without_a_state_directory_they_hold_for_the_session(tmp_path):
    assert keep(None, {"keeps_diary": False}) is None
    assert read(None, {}) == (Settings(), NOTHING)


@pytest.mark.parametrize(("value", "shown"), [("1", True), ("yes", True), ("", False), ("0", False), ("NO", False)])
def test_the_environment_rules_over_the_file(tmp_path, value, shown):  # R-C20
    keep(tmp_path, {"shows_warnings": not shown, "shows_lower": not shown})
    assert read(tmp_path, {"ONIKA_WARNINGS": value})[0] == Settings(shows_warnings=shown, shows_lower=not shown)
    assert read(tmp_path, {"ONIKA_LOWER": value})[0] == Settings(shows_warnings=not shown, shows_lower=shown)


def test_what_only_this_session_said_is_not_kept(tmp_path):  # R-C20, R-G05
    sentences, _ = read(tmp_path, {"ONIKA_LOWER": "no"})
    assert not sentences.shows_lower
    keep(tmp_path, {"shows_warnings": False})
    assert read(tmp_path, {})[0] == Settings(shows_warnings=False, shows_lower=True)


@pytest.mark.parametrize("content", [b"{", b'{"shows_warnings": 3}', b"\xff"])
def test_a_file_that_cannot_be_read_is_named_and_the_defaults_hold(tmp_path, content):  # R-B07
    (tmp_path / NAME).write_bytes(content)
    settings, wrong = read(tmp_path, {})
    assert settings == Settings()
    assert str(tmp_path / NAME) in str(wrong)


def test_where_they_cannot_be_written_the_reason_is_given(tmp_path):
    (tmp_path / "state").write_text("")
    assert isinstance(keep(tmp_path / "state", {"keeps_diary": True}), Refusal)


def test_a_unit_that_nobody_knows_is_that_of_files(tmp_path):  # R-G08
    keep(tmp_path, {"angle_unit": "deg", "length_unit": "furlong"})
    assert read(tmp_path, {})[0] == Settings(angle_unit="deg")


def test_how_icons_are_presented_holds_for_a_session_and_only_by_a_known_word(tmp_path):  # R-H04
    assert read(tmp_path, {"ONIKA_PRESENTATION": "words"})[0].presentation == "words"
    assert read(tmp_path, {"ONIKA_PRESENTATION": "smells"})[0].presentation == ""
    keep(tmp_path, {"shows_warnings": False})
    assert read(tmp_path, {})[0].presentation == ""
