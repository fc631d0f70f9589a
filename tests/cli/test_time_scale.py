import argparse

import pytest

from onika.cli.time_scale import scale


@pytest.mark.parametrize(("text", "number"), [("0.1", 0.1), ("10", 10.0), ("1e3", 1000.0)])
def test_a_scale_is_a_number(text, number):  # R-X08
    assert scale(text) == number


@pytest.mark.parametrize("text", ["", "x", "0", "-1", "nan", "inf", "1e9"])
def test_what_is_no_scale_is_refused(text):
    with pytest.raises(argparse.ArgumentTypeError, match="expected a number from"):
        scale(text)
