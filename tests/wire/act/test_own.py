import msgspec

from onika.wire import act


def test_a_button_is_pressed_by_its_name():
    assert msgspec.to_builtins(act.Press("reset")) == {"t": "Press", "name": "reset"}
