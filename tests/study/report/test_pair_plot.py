import dataclasses
import math
import xml.etree.ElementTree as ET

from onika.study.comparison import compare
from onika.study.report import pair_plot


def test_a_pair_that_differs_is_coloured_otherwise_and_one_without_limits_left_out():  # R-H03
    pairs = compare({"a": (1.0, 1.1, 1.2), "b": (1.1, 1.2, 1.3), "c": (5.0, 5.1, 5.2)}).pairs
    picture = pair_plot.drawn(pairs, "seconds")
    circles = [element for element in ET.fromstring(picture).iter() if element.tag.endswith("circle")]
    assert [circle.get("fill") for circle in circles] == ["var(--c0)", "var(--c1)", "var(--c1)"]
    lost = dataclasses.replace(pairs[0], low=math.nan)
    assert pair_plot.drawn([lost], "seconds").count("<circle") == 0
