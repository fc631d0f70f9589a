import msgspec

from onika.wire import act


def test_a_run_is_not_confirmed_unless_said():
    assert msgspec.to_builtins(act.Run("a1")) == {"t": "Run", "doc": "a1"}
