"""Why a model cannot be used, at its line."""

import pytest

from onika.wire.world_source import WorldFile
from onika.words.fault import Place
from onika.words.reason import Reason
from onika.workcell.composed.model_fault import line_of, model_fault

MODEL = WorldFile("robot/arm.xml", "arm.xml", b'<mujoco>\n<include file="x.xml"/>\n<body name="foot"/>\n</mujoco>')
PART = WorldFile("x.xml", "links.xml", b"<mujoco>\n\n<body name='tip'/></mujoco>")


def unsound(text):
    return Reason.of("workcell.model_unsound", why=Reason.plain(text))


@pytest.mark.parametrize(
    ("text", "prefix", "place"),
    [
        ("XML Error: bad format Element 'geom', line 3", "", Place("arm.xml", 3)),
        ("XML parse error 14: ErrorID=14 (0xe) Line number=4: XMLElement", "", Place("arm.xml", 4)),
        ("Error: mass Element name 'foot', id 1", "", Place("arm.xml", 3)),
        ("Error: mass Element name '1.foot', id 1, line 0", "1.", Place("arm.xml", 3)),
        ("Error: mass Element name 'tip', id 1, line 0", "", Place("links.xml", 3)),
        ("XML Error: Element 'body', line 0", "", Place("arm.xml", 2)),
    ],
)
def test_a_reason_of_mujoco_stands_at_the_line_or_the_element_that_it_names(text, prefix, place):  # R-B07, R-X19
    assert model_fault(unsound(text), [MODEL, PART], prefix).place == place


def test_a_reason_that_names_no_element_stands_at_the_model():  # R-B07
    assert model_fault(unsound("engine error"), [MODEL]).place == Place("arm.xml")


def test_a_reason_of_ours_names_its_joint():  # R-B07
    reason = Reason.of("workcell.limit_reversed", joint="tip", low=1.0, high=0.0)
    fault = model_fault(reason, [MODEL, PART])
    assert (fault.place, fault.args) == (Place("links.xml", 3), (reason,))


def test_the_line_of_a_file_that_is_wanted_is_found_by_its_attribute():
    assert [line_of(MODEL, "x.xml", r"file\w*"), line_of(MODEL, "nobody")] == [2, 0]
