import msgspec

from onika.wire import act


def test_an_alias_names_task_pin_and_variable():
    assert msgspec.to_builtins(act.Alias("pd", "X", "Q")) == {"t": "Alias", "task": "pd", "pin": "X", "svar": "Q"}
