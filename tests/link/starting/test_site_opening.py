import pytest

from onika.files.state.known_sites import KnownSites
from onika.link.channel import Channel
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_opening import SiteOpening
from onika.wire.site_card import LaunchCard, SiteCard, SiteHandOver
from onika.words.reason import Reason

NOBODY = 1
"""A port at which nobody listens."""


class BenchClient:
    """Answers for a site, and counts what it launched."""

    def __init__(self, identity="a", state="off"):
        self.identity, self.state, self.launched = identity, state, 0

    def launch(self):
        self.launched += 1
        return SiteHandOver("cmu", self.identity, "arm", NOBODY, True, False)

    def card(self):
        launches = (LaunchCard("arm", self.state, Reason.plain("it was killed")),)
        return SiteCard("cmu", self.identity, 0.0, "ann", "operator", launches)


@pytest.fixture
def opening(tmp_path):
    def to(client, name="arm", host="127.0.0.1"):
        address = SiteAddress(host, name=name, is_private=False)
        made = SiteOpening(address, "token", meets=KnownSites(tmp_path / "sites"))
        made._client = client
        return made

    return to


def lost(opening):
    with pytest.raises(LinkLost) as why:
        opening(Channel.SIGNAL)
    return why.value


def test_a_runtime_is_launched_once_and_its_end_is_final(opening):  # R-A15
    client = BenchClient()
    there = opening(client)
    assert [lost(there).cause for _ in range(3)] == [LossCause.OVER] * 3
    assert client.launched == 1
    assert "is not started anew by itself (it was killed)" in str(lost(there))


def test_while_the_site_says_that_it_runs_it_is_tried_again(opening):  # R-F04
    why = lost(opening(BenchClient(state="running")))
    assert why.cause is LossCause.UNREACHABLE and not why.is_final


def test_an_address_without_a_name_says_what_there_is(opening):  # R-A15
    assert "the site cmu launches arm" in str(lost(opening(BenchClient(), name="")))


def test_of_two_sites_of_one_name_the_second_is_refused(opening):  # R-F06
    lost(opening(BenchClient("a")))
    why = lost(opening(BenchClient("b"), host="127.0.0.2"))
    assert why.cause is LossCause.FORBIDDEN and why.is_final
    assert "127.0.0.2:7995 is called cmu, as another one, which was at 127.0.0.1:7995" in str(why)
