from msgspec import msgpack

from onika.ring.displacement import Displacement
from onika.words.reason import Reason

AWAY = Reason.of("workcell.arm_away", arm=Reason.of("workcell.the_arm"))


def test_it_travels_as_it_is_and_does_harm_unless_its_world_says_otherwise():  # law 18
    for displacement in (Displacement(AWAY), Displacement(AWAY, is_harmless=True)):
        assert msgpack.decode(msgpack.encode(displacement), type=Displacement) == displacement
    assert not Displacement(AWAY).is_harmless
