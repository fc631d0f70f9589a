from onika.cli.lines.site_text import card, launched, listed
from onika.files.state.known_sites import KnownSite
from onika.wire.booking import Booking
from onika.wire.site_card import LaunchCard, SiteCard, SiteHandOver
from onika.words.reason import Reason

ARM = LaunchCard(
    "arm", "running", worlds=("boxes",), robot="arm_left", holders={"flow0": "ann"}, users=("ann", "bob"),
    runs=("assemble",), bookings=(Booking(1, "ann", 0, 3600),),
)  # fmt: skip


def test_a_card_says_what_runs_who_holds_it_and_what_is_booked():  # R-F06 R-F09
    crane = LaunchCard("crane", "failed", Reason.plain("the port is taken"))
    lines = [str(line) for line in card(SiteCard("cmu", "id", 0.0, "ann", "operator", (ARM, crane)))]
    assert lines == [
        "cmu, 1970-01-01 00:00 UTC: you are ann, operator",
        "  arm: runs",
        "    worlds boxes",
        "    robot arm_left",
        "    assemble runs",
        "    ann holds flow0",
        "    there: ann, bob",
        "    booked for ann from 1970-01-01 00:00 UTC to 1970-01-01 01:00 UTC",
        "  crane: has failed",
        "    the port is taken",
    ]


def test_what_was_launched_and_what_ran_already_is_told_apart():  # R-A15
    new = SiteHandOver("cmu", "id", "arm", 7000, True, False)
    assert str(launched(new, "wss://cmu:7000")) == "arm was launched at cmu: wss://cmu:7000"
    assert "runs at cmu already" in str(launched(SiteHandOver("cmu", "id", "arm", 7000, False, False), "x"))


def test_sites_are_listed_in_order():
    sites = {"sandia": KnownSite("b" * 32, "b:1"), "cmu": KnownSite("a" * 32, "a:1")}
    assert [str(line).split()[0] for line in listed(sites)] == ["cmu", "sandia"]


def test_what_is_stopped_says_so():  # R-F06
    stopped = LaunchCard("arm", "running", is_stopped=True)
    lines = [str(line) for line in card(SiteCard("cmu", "x", 0.0, "ann", "viewer", (stopped,)))]
    assert "    everything is stopped there" in lines
