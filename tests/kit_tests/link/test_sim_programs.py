from kit.link.sim_programs import HONEST, Programs, SimEnvironment, SimRuntime, name_epoch
from onika.link.client import ClientEnd
from onika.link.session_channels import SessionChannels
from onika.link.sessions import Sessions


def test_honest_programs_are_the_real_ones():
    assert Programs() == HONEST
    assert (HONEST.client, HONEST.session_channels, HONEST.sessions) == (ClientEnd, SessionChannels, Sessions)
    assert name_epoch(1) != name_epoch(2)


def test_a_program_lives_and_has_a_clock_of_its_own():
    environment = SimEnvironment(0, "me", SessionChannels("me"), 7)
    house = SimRuntime(Sessions("life"), 9)
    assert (environment.is_up, environment.clock_ns, environment.plugs) == (True, 7, {})
    assert (house.is_up, house.clock_ns, house.plugs) == (True, 9, {})
