import msgspec

from onika.wire import act


def test_what_is_not_moved_does_not_travel():
    assert msgspec.to_builtins(act.Move("c1", {"pd": (1, 2)})) == {"t": "Move", "doc": "c1", "tasks": {"pd": (1, 2)}}
