from onika.wire import live, request


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
