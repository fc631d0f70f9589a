import msgspec

from onika.wire import view


def test_no_runtime_is_nothing():
    assert msgspec.to_builtins(view.RuntimeView()) == {}
