from onika.workcell.lamp_unit import LampUnit


def test_it_takes_no_command_and_has_six_contacts():
    lamp = LampUnit()
    assert lamp.sheet.command == ()
    assert lamp.sheet.state == ("time", "drive", *(f"contact{k}" for k in range(1, 7)))
    assert lamp.state[1] == 0.0


def test_it_is_lit_by_six_and_not_by_five():
    lamp = LampUnit()
    lamp.flags[:] = 1.0
    assert lamp.lit
    assert lamp.state[2:].tolist() == [1.0] * 6
    lamp.flags[3] = 0.0
    assert not lamp.lit
    lamp.restart()
    assert not lamp.flags.any()
