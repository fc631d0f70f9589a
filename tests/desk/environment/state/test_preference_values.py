from dataclasses import asdict, replace

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.preference_values import preference_values
from onika.model.preferences import Preferences, Window


def test_preferences_of_both_files_are_shown_by_one_name_each_and_places_together():  # R-G01
    model = Model()
    values = preference_values(model)
    assert len(values) == len(asdict(model.preferences)) - 8 + 1 + len(asdict(model.settings))
    assert values["shows_warnings"] == model.settings.shows_warnings


def test_only_places_that_somebody_has_chosen_are_shown():  # R-G01
    model = Model()
    assert preference_values(model)["places"] == {}
    moved = replace(model, preferences=replace(Preferences(), canvas=Window(200, 0, 700, 900)))
    assert preference_values(moved)["places"] == {"canvas": {"x": 200, "y": 0, "height": 700, "width": 900}}
