import re

import pytest

from kit.labs.library_site import LibrarySite
from kit.link.private_door import PrivateDoor
from onika.cli import main
from onika.files.state.kept_certificates import certificate_path
from onika.files.state.known_sites import KnownSites, known_sites_path
from onika.link.shown_certificate import fingerprint_of
from onika.link.starting.site_client import SiteClient
from onika.link.token import digest
from onika.store.remote.publication import fingerprint_of as key_fingerprint
from onika.wire.site_card import SiteCard

LIST = "VERSION 2.0\nLAUNCH arm\nWORLD boxes\nEOF\n"


@pytest.fixture
def listed(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    path = tmp_path / "list"
    path.write_text(LIST)
    return path


def test_a_list_that_is_at_fault_serves_nothing(listed, capsys):  # R-A15
    listed.write_text(LIST.replace("WORLD boxes", "COMMAND reboot"))
    assert main(["site", "serve", str(listed)]) == 2
    assert "list:3" in capsys.readouterr().err


def test_other_machines_are_let_in_with_certificate_and_users_only(listed, capsys):  # R-X12
    assert main(["site", "serve", str(listed), "--listen", "0.0.0.0"]) == 2
    assert [line.partition(":")[0] for line in capsys.readouterr().err.splitlines()] == ["--users", "--cert", "--key"]


def test_where_nobody_serves_that_is_told(listed, capsys, monkeypatch):  # R-A15
    monkeypatch.setenv("ONIKA_TOKEN", "x")
    assert main(["site", "card", "site://127.0.0.1:1"]) == 1
    assert "no site answers at site://127.0.0.1:1" in capsys.readouterr().err


@pytest.mark.parametrize("address", ["http://robot", "site://robot/a/b"])
def test_what_is_no_address_is_no_site(listed, capsys, address):  # R-A15
    with pytest.raises(SystemExit):
        main(["site", "launch", address])
    assert "expected site://" in capsys.readouterr().err


def test_sites_that_are_known_are_shown_and_forgotten(listed, capsys):  # R-F06
    KnownSites(known_sites_path()).meet("cmu", "abcdefghij", "cmu.example:7995")
    assert main(["site", "known"]) == 0
    assert "cmu  at cmu.example:7995  (abcdefgh)" in capsys.readouterr().out
    assert main(["site", "forget", "cmu"]) == 0
    assert main(["site", "forget", "cmu"]) == 1
    assert "no site is known as cmu" in capsys.readouterr().err


def test_where_a_site_and_its_library_are_is_said_and_with_which_key_it_is_signed(  # R-A15, R-F03
    listed, capsys, monkeypatch, tmp_path
):
    from onika.agent.program import SiteProgram

    users = listed.with_name("users")
    users.write_text(f"ann operator {digest('ann')}\n")
    monkeypatch.setenv("ONIKA_TOKEN", "ann")

    def run(program, on_ready):
        on_ready(program.place)
        program._listening.close()
        program._state.close()

    monkeypatch.setattr(SiteProgram, "run", run)
    words = ["site", "serve", str(listed), "--name", "cmu", "--listen", "127.0.0.1:0", "--users", str(users)]
    assert main(words) == 0
    only = capsys.readouterr().out
    assert "cmu listens on 127.0.0.1:" in only and only.count("\n") == 1
    library = LibrarySite(tmp_path)
    assert main([*words, "--library", str(library.base), "--library-key", str(library.key)]) == 0
    _, at, signed = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"its library wings is at http://127\.0\.0\.1:[0-9]+/library", at)
    assert signed == f"signed by {key_fingerprint(library.key.with_suffix('.pub'))}"


def test_a_certificate_that_its_machine_has_made_is_trusted_by_name_only(listed, capsys, tmp_path):  # R-F02
    door = PrivateDoor(tmp_path)
    place, right = f"127.0.0.1:{door.port}", fingerprint_of(door.der)
    try:
        assert main(["site", "trust", f"site://{place}/arm"]) == 1
        told = capsys.readouterr()
        assert right in told.out and "--sha256" in told.err
        assert main(["site", "trust", place, "--sha256", right.replace("A", "B").replace("1", "2")]) == 1
        assert not certificate_path("127.0.0.1").exists()
        assert main(["site", "trust", place, "--sha256", right.lower()]) == 0
        assert certificate_path("127.0.0.1").is_file()
    finally:
        door.close()


@pytest.mark.parametrize("act", ["card", "launch", "end"])
def test_another_site_of_a_known_name_is_told_and_not_asked_to_launch(listed, capsys, monkeypatch, act):  # R-F06
    def launched(*_):
        raise AssertionError

    monkeypatch.setenv("ONIKA_TOKEN", "x")
    monkeypatch.setattr(SiteClient, "card", lambda _: SiteCard("cmu", "b" * 32, 1.0, "ann", "operator"))
    monkeypatch.setattr(SiteClient, "launch", launched)
    monkeypatch.setattr(SiteClient, "end", launched)
    KnownSites(known_sites_path()).meet("cmu", "a" * 32, "cmu.example:7995")
    assert main(["site", act, "site://other.example/arm"]) == 1
    assert "as another one, which was at cmu.example:7995" in capsys.readouterr().err
