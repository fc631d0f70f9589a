from onika.cli.language import say
from onika.cli.lines.hindrance_lines import HindranceLines
from onika.wire import event
from onika.words.reason import NOTHING, Reason

FAILED = event.Failed("flow0", "jtraj", Reason.plain("too far"), "", 0, "", 2.0)


def held(at_s, *touches):
    reasons = tuple(map(Reason.plain, touches))
    return event.Drive("yard:crane", "HELD", 0, 0, 0, Reason.plain("commanded to hold"), at_s, NOTHING, reasons)


def test_what_was_in_the_way_is_told_behind_the_error():  # R-X06
    text = HindranceLines()
    assert text.line(FAILED, say) == ""
    assert text.line(held(2.0, "the arm meets itself", "the hand touches the floor"), say) == (
        "    2.00 s  in the way: the arm meets itself and the hand touches the floor"
    )


def test_an_arm_that_holds_for_another_reason_may_touch_what_it_touches():  # R-X06
    text = HindranceLines()
    assert text.line(held(1.0, "the hand touches the box"), say) == ""
    text.line(FAILED, say)
    assert text.line(held(2.0), say) == ""
    assert text.line(held(60.0, "the hand touches the box"), say) == ""
