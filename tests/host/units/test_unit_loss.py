from onika.host.units.unit_loss import dead_writers, ends_with


def test_the_writers_of_a_unit_die_with_it():  # R-X24, law 17
    homes = {"yard:m0": "rt0", "yard:m1": "rt1", "yard:m2": "rt0"}
    assert dead_writers("rt0", homes) == ("yard:m0", "yard:m2")
    assert dead_writers("rt2", homes) == ()


def test_a_run_ends_with_a_unit_of_its_tasks_and_with_the_device_server():  # R-X24
    assert ends_with("rt0", {"rt0", "rt1"})
    assert not ends_with("rt2", {"rt0", "rt1"})
    assert ends_with("", {"rt0"})
