import threading
from datetime import datetime, timedelta

import pytest

from kit.fabric.announced_site import AnnouncedSite
from onika.cli import main
from onika.cli.fabric import command
from onika.fabric.signed_card import SignedCard, opened


@pytest.fixture
def site(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return AnnouncedSite(tmp_path, "cmu.puma")


def carded(site, to, *more):
    return main(["fabric", "card", site.name, "--key", str(site.key), "--to", str(to), *more])


def test_a_site_is_carded_bound_found_and_trusted(site, tmp_path, capsys):  # R-F06
    runtime = ["--runtime", "wss://robots.cmu.edu:7994=arm,hand", "--library", "https://robots.cmu.edu/puma"]
    assert carded(site, tmp_path / "card", *runtime, "--desc", "Our PUMA") == 0
    assert main(["fabric", "book", str(tmp_path / "card"), "--to", str(tmp_path / "web")]) == 0
    assert main(["fabric", "list"]) == 0
    assert "no place is known" in capsys.readouterr().out
    assert main(["fabric", "add", str(tmp_path / "web")]) == 0
    assert main(["fabric", "trust", site.name, site.signer]) == 0
    assert main(["fabric", "list"]) == 0
    said = capsys.readouterr().out
    assert f"cmu.puma  known  {site.signer}" in said
    assert "runtime wss://robots.cmu.edu:7994  arm, hand" in said
    assert main(["fabric", "remove", str(tmp_path / "web")]) == 0


def test_a_card_is_newer_than_the_one_before_also_after_a_clock_an_hour_ahead(site, tmp_path, monkeypatch):  # R-F06
    class Ahead(datetime):
        @classmethod
        def now(cls, tz=None):
            return datetime.now(tz) + timedelta(hours=1)

    with monkeypatch.context() as wrong:
        wrong.setattr(command, "datetime", Ahead)
        assert carded(site, tmp_path / "card") == 0
    former = opened((tmp_path / "card").read_bytes())
    assert carded(site, tmp_path / "card") == 0
    now = opened((tmp_path / "card").read_bytes())
    assert isinstance(former, SignedCard) and isinstance(now, SignedCard)
    assert now.card.serial == former.card.serial + 1


def test_what_cannot_be_done_is_said_and_ends_with_one(site, tmp_path, capsys):  # R-F06
    next_key = str(tmp_path / "none.pub")
    for words in (
        ["card", "no name", "--key", str(site.key), "--to", str(tmp_path / "card")],
        ["card", "cmu", "--key", str(tmp_path / "none"), "--to", str(tmp_path / "card")],
        ["card", "cmu", "--key", str(site.key), "--to", str(tmp_path / "card"), "--next-key", next_key],
        ["card", "cmu", "--key", str(site.key), "--to", str(tmp_path / "card"), "--next-key", str(site.key)],
        ["book", str(tmp_path / "none"), "--to", str(tmp_path)],
        ["book", str(site.key), "--to", str(tmp_path)],
        ["announce", str(tmp_path / "none")],
        ["announce", str(site.key)],
        ["remove", "lan"],
        ["add", "ftp://x"],
        ["trust", "cmu", "SHA256:short"],
    ):
        assert main(["fabric", *words]) == 1
        assert capsys.readouterr().err
    assert not (tmp_path / "card").exists()


def test_a_router_and_an_announcement_begin_or_say_why_not(site, tmp_path, capsys, monkeypatch):  # R-F06
    assert carded(site, tmp_path / "card") == 0
    capsys.readouterr()

    def begins(*given):
        *_, until, ready = given
        assert isinstance(until, threading.Event)
        ready()
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "route", begins)
    monkeypatch.setattr(command, "announce", begins)
    assert main(["fabric", "router"]) == 0
    assert "tcp/127.0.0.1:7447" in capsys.readouterr().out
    assert main(["fabric", "announce", str(tmp_path / "card")]) == 0
    assert "announced: 1 card;" in capsys.readouterr().out

    def fails(wrong):
        def speak(*_):
            raise wrong

        return speak

    monkeypatch.setattr(command, "route", fails(ImportError()))
    assert main(["fabric", "router"]) == 1
    assert "onika[fabric]" in capsys.readouterr().err
    monkeypatch.setattr(command, "route", fails(OSError("in use")))
    assert main(["fabric", "router"]) == 1
    assert "in use" in capsys.readouterr().err
