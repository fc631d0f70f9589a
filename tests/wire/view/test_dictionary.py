import msgspec

from onika.wire import view


def test_a_type_has_two_edges():
    assert msgspec.to_builtins(view.TypeView(0, "nop", "1", "1")) == {
        "order": 0,
        "role": "nop",
        "left": "1",
        "right": "1",
    }
