import argparse
from pathlib import Path

import pytest

from onika.cli.search_path import directory, site_here


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


def test_a_base_directory_has_to_be_there(tmp_path):  # R-B07
    assert directory(str(tmp_path)) == str(tmp_path)
    assert directory(".") == "."
    for text in (str(tmp_path / "nowhere"), str(Path(__file__))):
        with pytest.raises(argparse.ArgumentTypeError, match="expected a base directory, found none at"):
            directory(text)
