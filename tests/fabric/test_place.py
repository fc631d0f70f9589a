from pathlib import Path

import pytest

from onika.fabric.place import RouterPlace, place_of, written
from onika.store.remote.address import WebAddress


def test_a_place_is_a_server_a_folder_a_router_or_this_network(tmp_path, monkeypatch):  # R-F06
    monkeypatch.chdir(tmp_path)
    assert isinstance(place_of("https://cmu.edu/sites"), WebAddress)
    assert place_of("sites") == tmp_path / "sites"
    assert place_of("tcp/[::1]:7447") == RouterPlace("tcp/[::1]:7447")
    assert place_of("lan") == RouterPlace()
    assert written("sites") == str(tmp_path / "sites")
    assert written("tls/cmu.edu:7447") == "tls/cmu.edu:7447"
    assert isinstance(place_of("~"), Path)


@pytest.mark.parametrize(
    "text", ["", "tcp/", "tcp/host", "tcp/host:x", "tcp/a b:1", "tcp/h:1#iface=eth0", "ftp://x", "https://a b", "a\nb"]
)
def test_what_is_none_is_refused_with_words(text):  # R-F06
    assert written(text).key in ("fabric.place_form", "store.address_form")
