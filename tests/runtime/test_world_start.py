import pytest

from kit.worlds.mass_world import MassWorld
from onika.ring.displacement import Displacement
from onika.runtime import world_start
from onika.words.reason import Reason


class Movable(MassWorld):
    """Masses that can be put back; a test says whether nothing outside moves."""

    def __init__(self, is_simulated):
        super().__init__()
        self.is_simulated = is_simulated
        self.resets = 0

    def reset(self):
        self.resets += 1


class Placed(Movable):
    """It knows where its things belong."""

    def places(self):
        return (Reason.plain("m0 at 0 m"), Reason.plain("m1 at 0 m"))

    def displaced(self):
        return (Displacement(Reason.plain("m1 is away")),)


def refused(world):
    with pytest.raises(ValueError) as refusal:
        world_start.put_back("yard", world)
    (reason,) = refusal.value.args
    return reason.key, reason.args


def test_a_simulated_world_that_can_is_put_back():  # law 18
    world = Movable(True)
    world_start.put_back("yard", world)
    assert world.resets == 1


def test_a_real_one_is_not_moved_and_what_a_person_has_to_put_where_is_told():  # law 18
    world = Placed(False)
    places = (Reason.plain("m0 at 0 m"), Reason.plain("m1 at 0 m"))
    assert refused(world) == ("runtime.put_back_by_hand", {"world": "yard", "places": places})
    assert world.resets == 0


@pytest.mark.parametrize("world", [Movable(False), Movable("yes"), MassWorld()])
def test_of_one_that_does_not_know_its_places_that_is_said(world):  # law 18
    assert refused(world) == ("runtime.put_all_back_by_hand", {"world": "yard"})


def test_what_is_away_is_told_by_a_world_that_knows_and_by_no_other():  # law 18
    assert world_start.displaced(Placed(True)) == (Displacement(Reason.plain("m1 is away")),)
    assert world_start.displaced(MassWorld()) == ()
