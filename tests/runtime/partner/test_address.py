"""Where a partner listens."""

import os
import socket

import pytest

from onika.runtime.partner.address import OWN_NAME, PartnerAddress


@pytest.mark.parametrize(
    ("words", "family", "place"),
    [
        ("unix:/tmp/x", socket.AF_UNIX, "/tmp/x"),
        ("tcp:127.0.0.1:7801", socket.AF_INET, ("127.0.0.1", 7801)),
        ("tcp:[::1]:7801", socket.AF_INET6, ("::1", 7801, 0, 0)),
    ],
)
def test_an_address_is_a_path_or_a_machine_and_its_port(words, family, place):  # R-F04
    address = PartnerAddress.parse(words)
    assert (address.words, address.family, address.place) == (words, family, place)


@pytest.mark.parametrize(
    "words",
    ["", "unix:", "unix:@", "tcp:", "tcp:host", "tcp::7801", "tcp:127.0.0.1:0", "tcp:127.0.0.1:70000", "http://x:1"],
)
def test_anything_else_is_refused(words):
    with pytest.raises(ValueError, match="expected unix:PATH or tcp:HOST:PORT"):
        PartnerAddress.parse(words)


def test_a_machine_that_nobody_knows_is_refused_when_it_is_read():
    with pytest.raises(ValueError, match=r"expected the name of a machine, found nowhere\.invalid"):
        PartnerAddress.parse("tcp:nowhere.invalid:7801")


def test_a_call_where_nobody_listens_says_so_at_once(tmp_path):
    with pytest.raises(FileNotFoundError):
        PartnerAddress.parse(f"unix:{tmp_path / 'nobody'}").call()


@pytest.mark.parametrize("family", [socket.AF_UNIX, socket.AF_INET])
def test_a_call_is_a_connection_that_never_blocks(tmp_path, family):
    with socket.socket(family) as server:
        server.bind(str(tmp_path / "x") if family == socket.AF_UNIX else ("127.0.0.1", 0))
        server.listen()
        words = f"unix:{tmp_path / 'x'}" if family == socket.AF_UNIX else f"tcp:127.0.0.1:{server.getsockname()[1]}"
        line, _ = PartnerAddress.parse(words).call()
        with line, server.accept()[0]:
            assert not line.getblocking()


def test_a_name_without_a_file_is_one_too():  # R-A20
    with socket.socket(socket.AF_UNIX) as server:
        server.bind("\0onika-test-of-addresses")
        server.listen()
        line, stands = PartnerAddress.parse("unix:@onika-test-of-addresses").call()
        line.close()
        assert stands


def test_a_runtime_has_a_name_of_its_own_in_addresses():  # R-A20
    address = PartnerAddress.parse("unix:@{runtime}/expert", {OWN_NAME: "7f3a"})
    assert (address.words, address.place) == ("unix:@7f3a/expert", "\0" + "7f3a/expert")
    assert PartnerAddress.parse("unix:@{runtime}/expert", {}).words == f"unix:@{os.getpid()}/expert"
