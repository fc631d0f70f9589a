import msgspec

from onika.wire import act


def test_what_stays_of_an_icon_does_not_travel():
    assert msgspec.to_builtins(act.EditOnikon("home", description="up")) == {
        "t": "EditOnikon",
        "onikon": "home",
        "description": "up",
    }
