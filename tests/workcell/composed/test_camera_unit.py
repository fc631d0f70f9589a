"""A camera as a device."""

import numpy as np

from onika.model.camera import CameraBlock
from onika.ring.drive import NEVER_NS
from onika.workcell.composed.camera_unit import CameraUnit

MS = 1_000_000


def test_it_counts_its_pictures_and_their_age_and_begins_anew_when_nobody_wanted_any():  # R-F05
    unit = CameraUnit("eye", CameraBlock("eye", size=(4, 2), rate=20.0), "eye", 1.0)
    unit.refresh(0.5)
    assert unit.state.tolist() == [0.5, 0.0, 0.0, 0.0]
    unit.take(np.ones((2, 4, 3), np.uint8), 500 * MS, 530 * MS)
    assert np.allclose(unit.state, [0.53, 0.0, 1.0, 0.03])
    assert unit.pixels.all()
    unit.rest()
    assert unit.state[2:].tolist() == [0.0, 0.0]


def test_its_instants_are_multiples_of_its_period():
    unit = CameraUnit("eye", CameraBlock("eye", rate=20.0), "eye", 1.0)
    assert unit.due_ns == NEVER_NS
    for now, due in ((-1, 0), (0, 50 * MS), (49 * MS, 50 * MS), (50 * MS, 100 * MS)):
        unit.schedule(now)
        assert unit.due_ns == due


def test_one_that_cannot_see_has_tripped():
    unit = CameraUnit("eye", CameraBlock("eye"), "eye", 1.0)
    unit.schedule(0)
    unit.darken()
    assert (unit.is_dark, unit.due_ns) == (True, NEVER_NS)
