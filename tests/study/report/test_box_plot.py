import xml.etree.ElementTree as ET

import pytest
from hypothesis import given, strategies as st

from onika.study.report import box_plot


def shapes(picture, kind):
    return [element for element in ET.fromstring(picture).iter() if element.tag.endswith(kind)]


def height(value, ticks=(0.0, 10.0)):
    return 256 - (value - ticks[0]) / (ticks[1] - ticks[0]) * 242


def test_a_box_reaches_from_quartile_to_quartile_and_every_subject_is_a_point():  # R-H03
    points = [(f"p{value}", float(value)) for value in (0, 2, 4, 6, 10)]
    picture = box_plot.drawn({"<both>": points}, "seconds")
    (box,) = shapes(picture, "rect")
    assert float(box.get("y")) == pytest.approx(height(6), abs=0.1)
    assert float(box.get("height")) == pytest.approx(height(2) - height(6), abs=0.1)
    circles = shapes(picture, "circle")
    assert [float(circle.get("cy")) for circle in circles] == pytest.approx([height(v) for _, v in points], abs=0.1)
    assert [title.text for title in shapes(picture, "title")][-1] == "p10: 10"
    assert "<both> (5)" in [text.text for text in shapes(picture, "text")]


def test_a_group_of_one_and_equal_values_are_drawn():  # R-H03
    assert len(shapes(box_plot.drawn({"a": [("p", 3.0)], "b": [("q", 3.0), ("r", 3.0)]}, "s"), "circle")) == 3
    assert shapes(box_plot.drawn({}, "s"), "circle") == []


@given(st.floats(-1e9, 1e9), st.floats(0, 1e9))
def test_ticks_hold_all_values_between_them_and_are_few(low, width):
    ticks = box_plot.ticks_of(low, low + width)
    nearly = 1e-6 * max(1, abs(low), width)
    assert ticks[0] <= low + nearly
    assert ticks[-1] >= low + width - nearly
    assert 2 <= len(ticks) <= 8
