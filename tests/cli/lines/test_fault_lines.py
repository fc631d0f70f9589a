"""Faults as lines: causes, with what follows from them."""

import pytest

from onika.cli.lines.fault_lines import fault_lines
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

CAUSE = Fault(Place("robot/arm.xml", 11), Reason.plain("expected a, found b"), Reason.plain("left out"))


def following(count):
    return [
        Fault(Place(f"module/m{n}.rmod"), Reason.plain("no device"), Reason.plain("not run"), because=(CAUSE.place,))
        for n in range(count)
    ]


@pytest.mark.parametrize(("count", "is_whole"), [(2, False), (3, True)])
def test_what_follows_from_a_fault_stands_behind_it_a_little_to_the_right(count, is_whole):  # R-B07
    lines = [str(line) for line in fault_lines([*following(count), CAUSE], is_whole=is_whole)]
    assert lines == [
        "robot/arm.xml:11: expected a, found b; instead: left out",
        *(f"  because of this: module/m{n}.rmod: no device; instead: not run" for n in range(count)),
    ]


def test_much_that_follows_is_one_line_with_how_much_and_where():  # R-B07
    lines = [str(line) for line in fault_lines([*following(3), CAUSE])]
    assert lines == [
        "robot/arm.xml:11: expected a, found b; instead: left out",
        "  because of this: 3 more faults (in m0.rmod, m1.rmod, m2.rmod)",
    ]
