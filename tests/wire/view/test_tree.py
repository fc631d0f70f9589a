import msgspec

from onika.wire import view


def test_what_is_empty_does_not_travel():
    assert msgspec.to_builtins(view.Tree(pictures={"k": "8"})) == {"pictures": {"k": "8"}}
