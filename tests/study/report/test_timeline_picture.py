import xml.etree.ElementTree as ET

import pytest

from kit.study.log_text import LogText
from onika.study import log as logs
from onika.study.report import timeline_picture
from onika.study.report.timeline_picture import LANES

NAMES = {lane: lane for lane in LANES}


def test_each_stretch_lies_in_the_lane_of_its_event_and_is_as_long_as_it_took():  # R-H02
    log = LogText().new(0).select(30, "<b>").insert(10).delete(20, 1).put(10, "open_view").run(10, 20)
    entries = logs.read(log.text, "x")[0].entries
    root = ET.fromstring(timeline_picture.drawn(entries, NAMES, "p1"))
    bars = [element for element in root.iter() if element.tag.endswith("rect")]
    lanes = [LANES[int((float(bar.get("y")) - 8) // 22)] for bar in bars]
    assert lanes == ["selection", "insertion", "deletion", "other", "check", "run"]
    widths = [float(bar.get("width")) for bar in bars]
    assert widths == pytest.approx([850 * s / 100 for s in (30, 10, 20, 10, 10, 20)], abs=0.11)
    assert "30.0 s: select_icon <b> (+30.0 s)" in [element.text for element in root.iter()]


def test_a_lone_entry_is_a_picture_too():  # R-H02
    entries = logs.read(LogText().new(0).text, "x")[0].entries
    assert "<rect" not in timeline_picture.drawn(entries, NAMES, "p1")
