from onika.host.foresight.situation import looked_at
from onika.ring.device import DriveState


def test_what_a_module_looks_at_stands_in_its_code():  # R-X24
    assert looked_at("self.check_drive()") == {DriveState.TRIPPED, DriveState.PRESSED}
    assert looked_at("if self.device.is_tripped: pass") == {DriveState.TRIPPED}
    assert looked_at("self.device.read()") == frozenset()
    assert looked_at("def (") == frozenset()
