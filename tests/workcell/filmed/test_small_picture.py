"""Pictures in a small form."""

import sys

import numpy as np
import pytest

from onika.workcell.filmed.small_picture import small_picture

PIXELS = np.full((24, 32, 3), 90, np.uint8)


def test_without_pillow_it_is_a_png(monkeypatch):  # R-F08
    monkeypatch.setitem(sys.modules, "PIL", None)
    assert small_picture(PIXELS).startswith(b"\x89PNG")


def test_with_pillow_it_is_a_jpeg():  # R-F08
    pytest.importorskip("PIL")
    assert small_picture(PIXELS).startswith(b"\xff\xd8")
