import msgspec

from onika.wire import view


def test_what_has_no_bounds_says_none():
    assert msgspec.to_builtins(view.AskView((view.AskItem("to", "double", 1, "rad", ""),))) == {
        "items": ({"name": "to", "type": "double", "count": 1, "unit": "rad", "meaning": ""},)
    }
