import msgspec

from onika.wire import act


def test_an_icon_goes_behind_the_start_icon_where_nothing_is_said():
    assert msgspec.to_builtins(act.InsertIcon("a1", "jmoveC")) == {"t": "InsertIcon", "doc": "a1", "onikon": "jmoveC"}
