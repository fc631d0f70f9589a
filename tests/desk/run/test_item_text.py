import pytest

from onika.desk.run.item_text import bounds, default
from onika.wire import event
from onika.words.reason import NOTHING, Reason, in_language


def item(low=None, high=None, default=None):
    return event.Item("q", "double", 2, "rad", "the joints", default, low, high)


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        ({"low": (-1.0, -2.5), "high": (1.0, 2.0)}, "from -1 -2.5 to 1 2"),
        ({"low": (0.25,)}, "at least 0.25"),
        ({"high": (1e6,)}, "at most 1e+06"),
    ],
)
def test_bounds_are_said_with_the_values_of_every_joint(settings, sentence):  # R-A10
    assert str(bounds(item(**settings))) == sentence


def test_what_has_no_bounds_and_no_default_says_nothing():  # R-A10
    assert (bounds(item()), default(item())) == (NOTHING, NOTHING)


def test_a_default_is_said_in_the_language_of_the_reader():  # R-A10
    values = default(item(default=("1", "2")))
    assert values == Reason.of("desk.item_default", values="1 2")
    assert in_language(values, "es") == "si no, 1 2"
