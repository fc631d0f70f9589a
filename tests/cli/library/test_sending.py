import pytest

from kit.labs.kept_library import KeptLibrary
from kit.labs.library_site import LibrarySite, wink
from kit.process.site_process import SiteProcess
from onika.cli import main
from onika.store.remote.publication import fingerprint_of

RMOD = "module/wink.rmod"


@pytest.fixture
def home(tmp_path, monkeypatch):
    for name, folder in (("HOME", "home"), ("XDG_CACHE_HOME", "cache"), ("XDG_STATE_HOME", "mine")):
        monkeypatch.setenv(name, str(tmp_path / folder))
    own = tmp_path / "home/onika"
    (own / "module").mkdir(parents=True)
    return own


def added(site: LibrarySite, address: str) -> int:
    return main(["library", "add", address, "--trust", str(fingerprint_of(site.key.with_suffix(".pub")))])


def test_what_has_become_of_a_change_is_told(home, tmp_path, capsys):  # R-F03
    with KeptLibrary(tmp_path) as kept:
        assert added(kept.site, kept.server.address) == 0
        assert main(["library", "send", "wings"]) == 1
        (home / RMOD).write_text(wink(says="blinks"))
        assert main(["library", "send", "wings", "--note", "blinks now"]) == 0
        assert "wings, version 2, has module/wink.rmod" in capsys.readouterr().out
        kept.change((RMOD, wink(says="blinks"), wink(says="glows")), user="bob")
        (home / RMOD).write_text(wink(says="blinks").replace("50", "60"))
        assert main(["library", "send", "wings", RMOD]) == 1
        assert "both was merged" in capsys.readouterr().err
        assert main(["library", "send", "wings", RMOD, "--agree"]) == 0
        assert kept.text(RMOD) == wink(says="glows").replace("50", "60")
        kept.change((RMOD, kept.text(RMOD), wink(says="shines")), user="bob")
        (home / RMOD).write_text(wink(says="is dark"))
        assert main(["library", "send", "wings"]) == 1
        assert "all versions lie in" in capsys.readouterr().err
        assert main(["library", "send", "wings", "--mine"]) == 0
        assert kept.text(RMOD) == wink(says="is dark")
    assert main(["library", "send", "nobody"]) == 1
    assert main(["library", "send", "wings", "module/none.rmod"]) == 1


@pytest.mark.site
def test_a_site_takes_changes_from_whoever_may_bring_code(home, tmp_path, capsys):  # R-F03
    far = LibrarySite(tmp_path)
    words = ("--library", str(far.base), "--library-key", str(far.key))
    site = SiteProcess(tmp_path / "site", more=words)
    try:
        tokens = tmp_path / "mine/onika/library-tokens"
        tokens.mkdir(parents=True, mode=0o700)
        (tokens / site.place).write_text("eve")
        (tokens / site.place).chmod(0o600)
        assert added(far, f"http://{site.place}/library") == 0
        (home / RMOD).write_text(wink(says="blinks"))
        assert main(["library", "send", "wings"]) == 1
        assert "eve is viewer here; programmer is wanted" in capsys.readouterr().err
        (tokens / site.place).write_text("pat")
        assert main(["library", "send", "wings"]) == 0
        assert (far.base / RMOD).read_text() == wink(says="blinks")
    finally:
        site.end()
    capsys.readouterr()
    assert main(["audit", str(site.state / "onika/audit/library-wings.log")]) == 0
    refused, taken, _ = capsys.readouterr().out.splitlines()
    assert "eve viewer  ChangeLibrary wings module/wink.rmod@" in refused and "programmer is wanted" in refused
    assert "pat programmer  ChangeLibrary wings module/wink.rmod@" in taken and taken.endswith(": version 2")
