from onika.wire import holding, live, request
from onika.words.reason import Reason


def test_a_stop_is_for_all_and_lasts_until_it_is_reset(sit):  # law 27
    sitting = sit()
    sitting.does("spawn puma")
    assert any("STOPPED: smoke; every drive holds until `reset`" in line for line in sitting.does("stop smoke"))
    assert str(sitting.fails("on puma").reason) == "expected the change to be done, found everything is stopped"
    assert any("motion is allowed again" in line for line in sitting.does("reset"))
    sitting.does("on puma")
    assert sitting.requests_of(request.Stop) == [request.Stop(Reason.plain("smoke"))]


def test_a_subsystem_is_taken_and_released(sit):  # R-X12
    sitting = sit()
    sitting.does("spawn puma")
    assert "main is held by you" in sitting.does("take")
    assert "main is held by nobody" in sitting.does("release main")
    sitting.runtime.refusals["Take"] = "held by ada"
    assert str(sitting.fails("take").reason) == "expected the runtime to do it, found held by ada"
    assert len(sitting.requests_of(live.Take)) == 2


def test_a_subsystem_is_offered_to_another_session_or_no_more(sit):  # R-X12
    sitting = sit()
    sitting.does("spawn puma")
    output = sitting.does("hand anna#2")
    assert "you offers main to anna#2, who may `take main` or `decline main`" in output
    assert sitting.requests_of(holding.Hand) == [holding.Hand("main", "anna#2")]
    assert "you offers main to nobody: withdrawn" in sitting.does("hand")
    sitting.does("hand bob arms")
    assert sitting.requests_of(holding.Hand)[-1] == holding.Hand("arms", "bob")
    sitting.runtime.refusals["Hand"] = "bob only watches and can take nothing"
    assert (
        str(sitting.fails("hand bob").reason)
        == "expected the runtime to do it, found bob only watches and can take nothing"
    )


def test_what_is_offered_is_declined(sit):  # R-X12
    sitting = sit()
    assert "anna#2 offers main to you: you declines" in sitting.does("decline")
    assert sitting.requests_of(holding.Decline) == [holding.Decline("main")]


def test_who_is_there_is_said_with_what_he_holds(sit):  # R-X12
    sitting = sit()
    sitting.does("take")
    sitting.runtime.sessions = (
        holding.SessionStanding("you", "owner", lease_s=0.25),
        holding.SessionStanding("anna#2", "viewer", is_here=False, only_watches=True, lease_s=1.0),
    )
    assert sitting.does("sessions") == [
        "you              owner       this console, silent for 0.25 s at most, holds main",
        "anna#2           viewer      away, only watches",
    ]


def test_a_console_that_only_watches_says_so(sit):  # R-X12
    sitting = sit()
    assert "this console only watches from now on; everybody can stop" in sitting.does("watch only")
    sitting.runtime.refusals["OnlyWatch"] = "this session holds main; release it first"
    assert str(sitting.fails("watch only").reason) == (
        "expected the runtime to do it, found this session holds main; release it first"
    )
