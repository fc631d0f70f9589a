from onika.wire import holding, live, request


def test_a_stop_is_for_all_and_lasts_until_it_is_reset(sit):  # law 27
    one = sit()
    one.does("spawn puma")
    assert any("STOPPED: smoke; every drive holds until `reset`" in line for line in one.does("stop smoke"))
    assert one.fails("on puma").found == "everything is stopped"
    assert any("motion is allowed again" in line for line in one.does("reset"))
    one.does("on puma")
    assert one.asked(request.Stop) == [request.Stop("smoke")]


def test_a_subsystem_is_taken_and_released(sit):  # R-X12
    one = sit()
    one.does("spawn puma")
    assert "main is held by you" in one.does("take")
    assert "main is held by nobody" in one.does("release main")
    one.runtime.refusals["Take"] = "held by ada"
    assert one.fails("take").found == "held by ada"
    assert len(one.asked(live.Take)) == 2


def test_the_network_channel_is_named_where_it_was_opened_at_the_start(sit):  # R-A16
    one = sit(addresses=("127.0.0.1:7994",))
    for line in ("open", "listen 127.0.0.1:7994", "network"):
        assert one.does(line) == ["others reach this runtime at 127.0.0.1:7994"]
    assert one.fails("open 0.0.0.0:1").found == "one that listens at 127.0.0.1:7994"


def test_where_it_was_not_opened_the_console_says_how(sit):  # R-A16
    fault = sit().fails("open 127.0.0.1:8000")
    assert fault.found == "one for this console alone"
    assert "`onika runtime --listen 127.0.0.1:8000`" in fault.instead


def test_a_subsystem_is_offered_to_another_session_or_no_more(sit):  # R-X12
    one = sit()
    one.does("spawn puma")
    said = one.does("hand anna#2")
    assert "you offers main to anna#2, who may `take main` or `decline main`" in said
    assert one.asked(holding.Hand) == [holding.Hand("main", "anna#2")]
    assert "you offers main to nobody: withdrawn" in one.does("hand")
    one.does("hand bob arms")
    assert one.asked(holding.Hand)[-1] == holding.Hand("arms", "bob")
    one.runtime.refusals["Hand"] = "bob only watches and can take nothing"
    assert one.fails("hand bob").found == "bob only watches and can take nothing"


def test_what_is_offered_is_declined(sit):  # R-X12
    one = sit()
    assert "anna#2 offers main to you: you declines" in one.does("decline")
    assert one.asked(holding.Decline) == [holding.Decline("main")]


def test_who_is_there_is_said_with_what_he_holds(sit):  # R-X12
    one = sit()
    one.does("take")
    one.runtime.sessions = (
        holding.SessionStanding("you", "owner", lease_s=0.25),
        holding.SessionStanding("anna#2", "viewer", is_here=False, only_watches=True, lease_s=1.0),
    )
    assert one.does("sessions") == [
        "you              owner       this console, silent for 0.25 s at most, holds main",
        "anna#2           viewer      away, only watches",
    ]


def test_a_console_that_only_watches_says_so(sit):  # R-X12
    one = sit()
    assert "this console only watches from now on; everybody can stop" in one.does("watch only")
    one.runtime.refusals["OnlyWatch"] = "this session holds main; release it first"
    assert one.fails("watch only").found == "this session holds main; release it first"
