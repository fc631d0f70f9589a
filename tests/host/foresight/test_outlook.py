from onika.host.foresight.outlook import Outlook
from onika.host.foresight.situation import Situation
from onika.ring.drive import DriveInput, DriveMode


def outlook(mode):
    return Outlook(Situation({}, {"yard:m0": mode}))


def states(of):
    return [(effect.after, effect.within_ms) for effect in of.effects]


def test_a_drive_that_hears_nothing_holds_and_trips_in_its_own_times():  # R-X24, law 17
    driven = outlook(DriveMode.DRIVEN)
    driven.silence(["yard:m0"], 1000.0)
    assert states(driven) == [("HELD", 60.0), ("TRIPPED", 260.0)]


def test_a_silence_that_ends_before_leads_no_farther():  # R-X24, law 17
    driven = outlook(DriveMode.DRIVEN)
    driven.silence(["yard:m0"], 100.0)
    assert states(driven) == [("HELD", 60.0)]


def test_a_drive_that_holds_as_it_was_told_does_not_trip_by_silence():  # R-X24, law 17
    held = outlook(DriveMode.HELD)
    held.silence(["yard:m0"], 1000.0)
    assert states(held) == []


def test_a_drive_moves_as_its_table_says():  # R-X24, law 17
    tripped = outlook(DriveMode.TRIPPED)
    tripped.drive("yard:m0", DriveInput.STOP, 0.0)
    assert states(tripped) == [("HELD", 10.0)]
    assert tripped.drives["yard:m0"].mode is DriveMode.STOPPED
    tripped.drive("elsewhere:m0", DriveInput.STOP, 0.0)
    assert len(tripped.effects) == 1
