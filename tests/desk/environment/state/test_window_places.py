import pytest

from onika.desk.environment.state.window_places import WINDOWS, chosen_places, places_of
from onika.model.preferences import Preferences, Window, WindowCorner


def test_the_windows_are_those_of_the_dissertation():  # R-G01
    assert set(WINDOWS) == {
        *("library", "canvas", "status", "variables", "dictionary", "workspace", "main", "buttons"),
    }
    assert chosen_places(Preferences()) == {}


def test_places_are_taken_as_a_page_says_them():  # R-G01
    values = {"status": {"x": 0, "y": 700.0}, "library": {"x": 1, "y": 2, "height": 300, "width": 200}}
    assert places_of(values) == {"status": WindowCorner(0, 700), "library": Window(1, 2, 300, 200)}


@pytest.mark.parametrize(
    ("values", "key"),
    [
        ("left", "run.places_form"),
        ({"cellar": {"x": 0, "y": 0}}, "run.places_form"),
        ({"status": {"x": 0}}, "run.place_form"),
        ({"status": [0, 0]}, "run.place_form"),
        ({"status": {"x": 0, "y": 0, "height": 1, "width": 1}}, "run.place_form"),
        ({"library": {"x": 0, "y": 0, "height": 300, "width": "wide"}}, "run.place_form"),
        ({"status": {"x": -1, "y": 0}}, "run.place_form"),
        ({"status": {"x": 0.5, "y": 0}}, "run.place_form"),
        ({"status": {"x": 0, "y": True}}, "run.place_form"),
        ({"status": {"x": 0, "y": 20_001}}, "run.place_form"),
    ],
)
def test_what_is_no_place_is_refused_with_what_one_is(values, key):  # R-G01
    with pytest.raises(ValueError) as refused:
        places_of(values)
    assert refused.value.args[0].key == key
