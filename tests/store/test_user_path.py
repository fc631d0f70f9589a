from pathlib import Path

import pytest

from onika.store.user_path import user_path
from onika.words.reason import Reason


def test_a_path_is_absolute_and_its_home_is_found(monkeypatch, tmp_path):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert user_path("~/onika", tmp_path / "own") == tmp_path / "onika"
    assert user_path("lab", tmp_path / "own") == tmp_path / "own" / "lab"
    assert user_path("lab", None) == tmp_path / "lab"
    assert user_path("/", tmp_path) == Path("/")


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ("a\0b", "store.path_null"),
        ("/tmp/" + "x" * 256, "store.path_long"),
        ("/a" * 4000, "store.path_long"),
        ("é" * 200, "store.path_long"),
        ("~nobody-of-this-name/x", "store.path_home"),
    ],
)  # R-B07
def test_what_no_file_system_allows_is_said(text, key):
    reason = user_path(text, None)
    assert isinstance(reason, Reason)
    assert reason.key == key
