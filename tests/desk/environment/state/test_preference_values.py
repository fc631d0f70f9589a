from dataclasses import asdict

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.preference_values import preference_values


def test_preferences_of_both_files_are_shown_by_one_name_each():  # R-G01
    model = Model()
    values = preference_values(model)
    assert len(values) == len(asdict(model.preferences)) - 8 + len(asdict(model.settings))
    assert values["shows_warnings"] == model.settings.shows_warnings


def test_what_changes_nothing_is_not_offered():  # R-G01
    assert {"canvas", "main"}.isdisjoint(preference_values(Model()))
