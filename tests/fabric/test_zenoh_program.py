"""What speaks Zenoh: its settings, and, where Zenoh is installed, a real router with real cards."""

import socket
import threading

import pytest

from kit.fabric.announced_site import AnnouncedSite
from onika.fabric.place import RouterPlace
from onika.fabric.router_cards import router_cards
from onika.fabric.zenoh_program import CARDS, announce, main, route, settings, shards


def test_the_open_defaults_of_zenoh_are_shut():  # R-F06
    given = settings("client", ["tcp/h:1"], waits_s=2.5)
    assert given["scouting/multicast/enabled"] is given["scouting/gossip/enabled"] is False
    assert given["listen/endpoints"] == []
    assert (given["connect/timeout_ms"], given["connect/exit_on_failure"]) == (2500, True)
    lasting = settings("client", is_lan=True)
    assert (lasting["connect/timeout_ms"], lasting["connect/exit_on_failure"]) == (-1, False)
    assert lasting["scouting/multicast/enabled"] is True


def test_few_cards_are_asked_for_at_a_time_and_all_of_them():  # R-F06
    assert shards(()) == []
    assert shards(f"{number:032x}" for number in range(50)) == [f"{CARDS}/*"]
    names = [f"{number * 0x01000000:08x}" for number in range(256)]
    assert shards(names) == [f"{CARDS}/{digit}$*" for digit in "0123456789abcdef"]
    assert len(shards(f"00000{number}" for number in range(200))) == 1  # names that somebody made up


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as there:
        return there.getsockname()[1]


def begun(speak, until):
    ready = threading.Event()
    thread = threading.Thread(target=speak, args=(until, ready.set), daemon=True)
    thread.start()
    assert ready.wait(20)
    return thread


def test_what_is_announced_at_a_router_is_found_there_until_it_ends(tmp_path):  # R-F06
    pytest.importorskip("zenoh", reason="eclipse-zenoh is an extra")
    place = f"tcp/127.0.0.1:{free_port()}"
    cards = [AnnouncedSite(tmp_path, name).card() for name in ("cmu", "mit")]
    router_ends, site_ends = threading.Event(), threading.Event()
    router = begun(lambda until, ready: route([place], [], None, until, ready), router_ends)
    site = begun(lambda until, ready: announce(cards, place, None, until, ready), site_ends)
    assert sorted(router_cards(RouterPlace(place), 20.0)) == sorted(cards)
    site_ends.set()
    site.join(20)
    assert router_cards(RouterPlace(place), 20.0) == ()
    router_ends.set()
    router.join(20)
    assert router_cards(RouterPlace(place), 4.0).key == "fabric.router_silent"


def test_a_router_that_is_not_there_ends_the_program_with_one(capsys):  # R-F06
    assert main(["list", "tcp/127.0.0.1:1", "0.3"]) == 1
    assert capsys.readouterr().out == ""
