from onika.desk.environment.state.measuring import MeasuringSubsystem
from onika.words.reason import NOTHING, Reason


def test_it_remembers_how_each_change_has_ended():
    why = Reason.plain("not now")
    subsystem = MeasuringSubsystem("measuring").ended(1, NOTHING).ended(2, why)
    assert dict(subsystem.ends) == {1: NOTHING, 2: why}
