from types import SimpleNamespace

import pytest

from onika.cli.search_path import access_here, site_here
from onika.store.remote.credential import Credential
from onika.words.reason import Reason


def test_directories_of_the_command_line_come_first_then_those_of_the_environment(tmp_path, monkeypatch):  # reading 11
    for name in ("one", "two", "three"):
        (tmp_path / name).mkdir()
    monkeypatch.setenv("ONIKA_LOCAL", str(tmp_path / "three"))
    monkeypatch.setenv("HOME", str(tmp_path))
    site = site_here([str(tmp_path / "one"), str(tmp_path / "two")])
    names = [base.path.name for base in site.directories]
    assert names[:3] == ["one", "two", "three"]
    assert {"boxes", "generic", "puma"} <= set(names[3:])
    assert site.home == tmp_path


@pytest.mark.parametrize(
    ("name", "typed", "credential"),
    [("ann", "secret", Credential("secret", "ann")), ("", "a token", Credential("a token")), ("", "", None)],
)
def test_at_a_terminal_one_is_asked_for_a_password_or_a_token(monkeypatch, name, typed, credential):  # R-F03
    asked = []
    monkeypatch.setattr("sys.stdin", SimpleNamespace(isatty=lambda: True))
    monkeypatch.setattr("builtins.input", lambda _: name)
    monkeypatch.setattr("getpass.getpass", lambda question: asked.append(question) or typed)
    ask = access_here()._ask
    assert ask is not None
    assert ask("cmu.example", Reason.of("store.password_needed", host="cmu.example")) == credential
    assert asked == ["password: " if name else "token (nothing: go without): "]
