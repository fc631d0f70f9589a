import pytest

from kit.labs.laboratory import Laboratory, job
from kit.labs.library_server import LibraryServer
from kit.labs.library_site import WINK_CODE, LibrarySite, new_key, wink
from onika.cli import main
from onika.cli.search_path import site_here
from onika.store.remote.publication import fingerprint_of

_MORE = WINK_CODE.replace("    LAMP =", '    Q_MEZ = OutVar("double", "rad", "nobody has agreed to this")\n    LAMP =')


@pytest.fixture
def site(tmp_path, monkeypatch) -> LibrarySite:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "home").mkdir()
    site = LibrarySite(tmp_path)
    Laboratory(site.base).configuration("winkC", "wink 50")
    Laboratory(site.base).application("evening", [job("winkC")])
    return site


def published(site: LibrarySite) -> int:
    return main(["library", "publish", str(site.base), "--to", str(site.folder), "--key", str(site.key)])


def added(site: LibrarySite, address: str = "") -> int:
    signer = fingerprint_of(site.key.with_suffix(".pub"))
    return main(["library", "add", address or str(site.folder), "--trust", str(signer)])


def test_what_one_site_publishes_another_runs(site, capsys):  # R-F03 R-F11
    assert published(site) == 0
    with LibraryServer(site.folder) as server:
        assert added(site, server.address) == 0
        assert len(server.asked) == 1
        assert main(["run", "evening", "--virtual", "--expect", "LAMP == 1"]) == 0
        assert len(server.asked) == 2
    assert main(["run", "evening", "--virtual", "--expect", "LAMP == 1"]) == 0  # the server is gone
    assert "evening: completed" in capsys.readouterr().out


def test_code_that_writes_more_than_its_task_declares_is_not_run(site, capsys):  # R-X16
    site.write("module/wink.py", _MORE)
    assert published(site) == 0
    assert added(site) == 0
    capsys.readouterr()
    assert main(["run", "evening", "--virtual"]) != 0
    said = capsys.readouterr()
    assert "Q_MEZ" in said.out + said.err


def test_nothing_is_used_before_its_key_is_trusted(site, tmp_path, capsys):  # R-X16
    published(site)
    assert main(["library", "add", str(site.folder)]) == 1
    assert "nobody has trusted the key" in capsys.readouterr().err
    wrong = fingerprint_of(new_key(tmp_path, "eve").with_suffix(".pub"))
    assert main(["library", "add", str(site.folder), "--trust", str(wrong)]) == 1
    assert not (tmp_path / "home/onika").exists()
    assert main(["library", "list"]) == 0
    assert "no libraries of others" in capsys.readouterr().out


def test_what_is_new_is_shown_and_what_is_written_further_is_agreed_to(site, capsys):  # R-X16
    published(site)
    added(site)
    assert main(["library", "update"]) == 0
    assert "nothing new" in capsys.readouterr().out
    site.write("module/wink.rmod", wink("LAMP", "Q_MEZ"))
    published(site)
    assert main(["library", "update", "wings"]) == 1
    said = capsys.readouterr()
    assert "wink would further write or touch Q_MEZ" in said.out
    assert "nobody has agreed" in said.err
    assert main(["library", "list"]) == 0
    assert "wings 1," in capsys.readouterr().out
    assert main(["library", "update", "wings", "--agree"]) == 0
    assert main(["library", "list"]) == 0
    assert "wings 2," in capsys.readouterr().out


def test_a_library_is_looked_through_whether_it_is_used_or_not(site, capsys):  # R-F06
    published(site)
    capsys.readouterr()
    assert main(["library", "browse", str(site.folder), "--search", "winks"]) == 0
    assert "task wink: winks" in capsys.readouterr().out
    added(site)
    site.write("module/blink.rmod", wink(says="blinks"))
    published(site)
    capsys.readouterr()
    assert main(["library", "browse", "wings"]) == 0
    assert "+ task blink: blinks" in capsys.readouterr().out


def test_a_lock_may_stand_beside_an_application(site, tmp_path):  # R-X16
    published(site)
    (tmp_path / "project").mkdir()
    signer = fingerprint_of(site.key.with_suffix(".pub"))
    words = ["library", "add", str(site.folder), "--trust", str(signer), "--local", str(tmp_path / "project")]
    assert main(words) == 0
    assert (tmp_path / "project/onika.lock").is_file()
    assert site_here([str(tmp_path / "project")]).directories[-1].path.name == "wings"


def test_a_library_is_fetched_whole_and_removed(site, tmp_path, capsys):  # R-F03
    published(site)
    added(site)
    assert main(["library", "fetch"]) == 0
    assert main(["library", "list"]) == 0
    assert "0 files to fetch" in capsys.readouterr().out
    assert main(["library", "remove", "wings"]) == 0
    assert main(["library", "remove", "wings"]) == 1
    assert main(["library", "fetch", "wings"]) == 1
    assert not list((tmp_path / "cache").rglob("wink.rmod"))


def test_what_was_changed_in_the_cache_is_named_when_it_is_fetched_anew(site, tmp_path, capsys):  # R-X16
    published(site)
    added(site)
    main(["library", "fetch"])
    for kept in (tmp_path / "cache/onika/objects").rglob("*"):
        if kept.is_file() and kept.read_text(errors="replace") == WINK_CODE:
            kept.write_text(WINK_CODE.replace("1 - ", "7 - "))
    main(["library", "list"])
    assert "1 file to fetch" in capsys.readouterr().out
    assert main(["library", "fetch"]) == 0
    shown = capsys.readouterr()
    assert "module/wink.py" in shown.err and "changed in the cache" in shown.err
    assert main(["library", "list"]) == 0
    assert "0 files to fetch" in capsys.readouterr().out


def test_another_key_is_trusted_by_hand(site, tmp_path, capsys):  # R-X16
    published(site)
    added(site)
    site.key = new_key(tmp_path, "other")
    published(site)
    assert main(["library", "update"]) == 1
    assert "signed by another key" in capsys.readouterr().err
    assert main(["library", "trust", "wings", "SHA256:short"]) == 1
    assert main(["library", "trust", "wings", str(fingerprint_of(site.key.with_suffix(".pub")))]) == 0
    assert main(["library", "update"]) == 0


def test_what_cannot_be_published_is_said(site, tmp_path, capsys):  # R-B07
    words = ["library", "publish", str(site.base), "--to", str(tmp_path / "to")]
    assert main([*words, "--key", str(tmp_path / "none")]) == 1
    assert "could not be signed" in capsys.readouterr().err
    assert main([*words, "--key", str(site.key), "--next-key", str(tmp_path / "none")]) == 1
    with pytest.raises(SystemExit):
        main([*words, "--key", str(site.key), "--days", "0"])
