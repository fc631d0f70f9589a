from onika.model.button import Button


def test_a_button_runs_its_command_without_a_terminal_unless_said() -> None:
    assert not Button("clock", "xclock").spawns_terminal  # R-G02
