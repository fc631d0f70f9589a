import msgspec

from onika.wire import view


def test_a_supermodule_is_its_tasks():
    assert msgspec.to_builtins(view.GroupView(("a", "b"))) == {"tasks": ("a", "b")}
