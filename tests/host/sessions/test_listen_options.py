import stat

import pytest

from onika.host.sessions.listen_options import ListenOptions, judge
from onika.link.caller import Role
from onika.link.token import digest, read_token


@pytest.fixture
def home(tmp_path):
    return {"XDG_STATE_HOME": str(tmp_path)}


def places(wanted, home):
    place, faults, _ = judge(wanted, home)
    assert place is None
    return [fault.place.file for fault in faults]


@pytest.mark.parametrize("listen", ["127.0.0.1:0", "localhost:7994", "[::1]:1", "127.0.0.1"])
def test_on_this_machine_a_token_is_enough_and_made_once(listen, home, tmp_path):  # R-X12
    place, faults, token_at = judge(ListenOptions(listen), home)
    assert (faults, place.certificate) == ([], "")
    assert token_at == str(tmp_path / "onika" / "token")
    token = read_token(tmp_path / "onika" / "token")
    assert [(user.name, user.role, user.digest) for user in place.users] == [("owner", Role.OWNER, digest(token))]
    assert stat.S_IMODE((tmp_path / "onika" / "token").stat().st_mode) == 0o600
    assert judge(ListenOptions(listen), home)[0] == place


@pytest.mark.parametrize("listen", ["0.0.0.0:0", "[::]:0", "192.0.2.1:7994", "robot.example:7994"])
def test_to_other_machines_it_is_closed_until_nothing_is_missing(listen, home, tmp_path):  # R-X12
    assert places(ListenOptions(listen), home) == ["--users", "--cert", "--key"]
    assert places(ListenOptions(listen, "c", "k"), home) == ["--users", "c"]
    assert places(ListenOptions(listen, certificate="c", users=str(tmp_path)), home) == [str(tmp_path), "--key"]
    empty = tmp_path / "users"
    empty.write_text("# nobody\n")
    assert places(ListenOptions(listen, users=str(empty)), home) == [str(empty), "--cert", "--key"]
    assert not (tmp_path / "onika").exists()


def test_half_a_certificate_is_told_on_this_machine_too(home):
    assert places(ListenOptions("localhost:0", certificate="c"), home) == ["--key"]


@pytest.mark.parametrize("listen", ["", ":1", "robot:x", "robot:99999", "http://robot"])
def test_what_is_no_place_is_told(listen, home):
    assert places(ListenOptions(listen), home) == ["--listen"]


def test_the_address_names_the_port_that_was_taken(home):
    place, _, _ = judge(ListenOptions("[::1]:0"), home)
    assert place.address(8123) == "ws://[::1]:8123"
