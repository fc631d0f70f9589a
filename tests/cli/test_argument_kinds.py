import argparse
from pathlib import Path

import pytest

from onika.cli.argument_kinds import directory, scale, script_file


def test_a_base_directory_has_to_be_there(tmp_path):  # R-B07
    assert directory(str(tmp_path)) == str(tmp_path)
    assert directory(".") == "."
    for text in (str(tmp_path / "nowhere"), str(Path(__file__))):
        with pytest.raises(argparse.ArgumentTypeError, match="expected a base directory, found none at"):
            directory(text)


def test_a_script_has_to_be_there(tmp_path):  # R-E07
    path = tmp_path / "lines"
    path.write_text("pause\n")
    assert script_file(str(path)) == path
    with pytest.raises(argparse.ArgumentTypeError, match="expected a file of lines, found none at"):
        script_file(str(tmp_path))


@pytest.mark.parametrize(("text", "number"), [("0.1", 0.1), ("10", 10.0), ("1e3", 1000.0)])
def test_a_scale_is_a_number(text, number):  # R-X08
    assert scale(text) == number


@pytest.mark.parametrize("text", ["", "x", "0", "-1", "nan", "inf", "1e9"])
def test_what_is_no_scale_is_refused(text):
    with pytest.raises(argparse.ArgumentTypeError, match="expected a number from"):
        scale(text)
