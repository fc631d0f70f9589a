from onika.host.run.replay import Replay
from onika.wire import request, steer
from onika.wire.request import Recorded, encode
from onika.words.reason import Reason

SECOND = 1_000_000_000
PAUSE, ANSWER = steer.Pause("flow0"), request.Reply("flow0", "gauge", "1")


def repeated(*requests, until_ns=10 * SECOND, now=0):
    repeat = Replay()
    inputs = tuple(Recorded(at, turn, encode(wish)) for at, turn, wish in requests)
    repeat.begin("me", request.Begin(repeat=inputs, repeat_until_ns=until_ns), now, ("flow0", "flow1"))
    return repeat


def test_a_request_comes_at_its_instant_and_after_its_turn():  # law 29
    repeat = repeated((SECOND, 2, PAUSE), now=SECOND)
    assert repeat.take(SECOND, 9, False) is None
    assert repeat.wake_at(SECOND) == 2 * SECOND
    assert repeat.take(2 * SECOND, 1, False) is None
    assert repeat.take(2 * SECOND, 2, False) == PAUSE
    assert repeat.wake_at(2 * SECOND) == 11 * SECOND


def test_an_answer_waits_for_its_question_and_a_question_for_nothing():  # law 25
    repeat = repeated((0, 0, ANSWER), (5 * SECOND, 1, PAUSE))
    assert repeat.take(0, 3, False) is None
    assert repeat.take(0, 3, True) == ANSWER
    assert repeat.take(0, 3, False) is None
    assert repeat.take(0, 3, True) == PAUSE


def test_an_answer_that_nobody_asks_for_holds_nothing_up():
    repeat = repeated((0, 0, ANSWER))
    assert repeat.take(1, 0, False) == ANSWER


def test_it_is_on_up_to_its_instant_and_nobody_else_steers_meanwhile():  # R-X05
    repeat = repeated()
    assert repeat.is_on(10 * SECOND - 1)
    assert "being repeated" in repeat.refusal("you", PAUSE, 0).text
    assert not repeat.refusal("me", request.Abort(Reason.plain("enough")), 0)
    assert not repeat.refusal("me", steer.Who(), 0)
    assert not repeat.is_on(10 * SECOND)
    assert not repeat.refusal("me", PAUSE, 10 * SECOND)
    assert repeat.wake_at(10 * SECOND) is None


def test_a_whole_run_is_repeated_to_its_end():
    repeat = repeated(until_ns=-1)
    assert repeat.is_on(10**18)
    repeat.lost("other")
    repeat.end(("flow2",))
    assert repeat.is_on(0)
    repeat.end(("flow0", "flow1"))
    assert not repeat.is_on(0)
    repeat = repeated(until_ns=-1)
    repeat.lost("me")
    assert not repeat.is_on(0)


def test_a_run_of_another_that_begins_and_is_steered_leaves_a_repeated_run_as_it_is():  # law 29, R-C18
    repeat = repeated((5 * SECOND, 0, PAUSE))
    repeat.begin("you", request.Begin(), SECOND, ("flow2",))
    assert repeat.is_on(SECOND) and repeat.session == "me"
    assert not repeat.refusal("you", steer.Pause("flow2"), SECOND)
    assert repeat.refusal("you", steer.Pause("flow1"), SECOND)
    assert repeat.refusal("you", steer.Pause(), SECOND)
    repeat.end(("flow2",))
    assert repeat.take(5 * SECOND, 1, False) == PAUSE


def test_two_runs_are_not_repeated_at_once():  # law 29
    repeat = repeated()
    assert "repeated" in repeat.objection(request.Begin(repeat_until_ns=-1), SECOND).text
    assert not repeat.objection(request.Begin(), SECOND)
    assert not repeat.objection(request.Begin(repeat_until_ns=-1), 10 * SECOND)


def test_what_is_not_repeated_waits_for_nothing():
    repeat = repeated(until_ns=0)
    assert not repeat.is_on(0)
    assert repeat.wake_at(0) is None
    assert repeat.take(0, 0, True) is None
