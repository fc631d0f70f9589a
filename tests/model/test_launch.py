from onika.model.launch import UNITS, Launch


def test_what_is_not_said_is_the_safe_way():  # R-A15
    launch = Launch("arm")
    assert launch.units == UNITS
    assert not (launch.takes_code or launch.stays or launch.port)
