import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, event
from onika.words.reason import NOTHING, Reason

TOUCHES = Reason.plain("the hand touches the table")
STANDS = Reason.plain("the hand stands at x = 1.0 cm")


@pytest.fixture
def play(tmp_path):
    """Its task `a` has the device `arm`, and so has nobody else."""
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC"), job("bC")]))
    play.began(0)
    return play


def held(at_s, state="HELD", device="arm", touches=(TOUCHES,), stands=STANDS):
    return event.Drive(device, state, 0, 0, 0, NOTHING, at_s, stands, touches)


def stopped(play, at_s=2.0):
    play.tell(
        event.Explained(
            "flow0",
            "a",
            "aC",
            0,
            "",
            Reason.plain("no"),
            "",
            0,
            (),
            (),
            (("abort", Reason.plain("ends")),),
            at_s,
            "error",
        )
    )


def told(play):
    stop = play.view.stops["flow0"]
    return stop.touches, stop.stands


@pytest.mark.parametrize("is_first", [True, False])
def test_a_standstill_says_what_was_in_the_way_whichever_is_told_first(play, is_first):  # R-X06
    if is_first:
        play.tell(held(2.1))
    stopped(play)
    if not is_first:
        assert told(play) == ((), ())
        play.tell(held(2.1))
    assert told(play) == ((TOUCHES,), (STANDS,))


def test_of_a_hold_long_before_or_of_another_device_nothing_is_said(play):  # R-X06
    play.tell(held(0.5))
    play.tell(held(2.0, device="other"))
    stopped(play)
    assert told(play) == ((), ())


def test_an_arm_that_follows_again_is_not_held_up_any_more(play):  # R-X06
    play.tell(held(1.9))
    play.tell(held(1.95, state="DRIVEN", touches=(), stands=NOTHING))
    stopped(play)
    assert told(play) == ((), ())


def test_a_run_that_stands_is_ended_put_back_and_begun_anew_at_one_press(play):  # R-X06, law 18
    stopped(play)
    number, doc = play.view.number, play.view.doc
    play.do(act.Run(doc, puts_back=True, ends_former=True))
    assert (play.view.number, play.view.state) == (number + 1, "running")
    assert play.view.stops == {}
