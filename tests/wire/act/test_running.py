import msgspec

from onika.wire import act


def test_stop_needs_no_words():
    assert msgspec.to_builtins(act.Stop()) == {"t": "Stop"}
