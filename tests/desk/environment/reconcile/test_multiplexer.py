import pytest

from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.reconcile.multiplexer import Multiplexer
from onika.desk.run.runtime_conversation import NumberedResponse
from onika.link.lost import LinkLost, LossCause
from onika.wire import event, live, request
from onika.words.reason import Reason

FIGURES = live.Figures((), {"rt0": 0.5})


class Wire:
    """A runtime whose words are planned; `sent` is what it was asked."""

    def __init__(self):
        self.sent = []
        self.words = []

    def send(self, wish):
        self.sent.append(wish)
        return len(self.sent)

    def messages(self, timeout_s=0.0):
        words, self.words = self.words, []
        for word in words:
            if isinstance(word, LinkLost):
                raise word
            yield word

    def readings(self):
        return {"main/X": b"1"}


@pytest.fixture
def wire():
    return Wire()


@pytest.fixture
def now():
    return [0.0]


@pytest.fixture
def multiplexer(wire, now):
    return Multiplexer(wire, lambda: now[0])


def test_orders_and_events_are_told_in_the_order_in_which_they_came(multiplexer, wire):
    first, second = Order(live.Survey()), Order(request.Stop(Reason.plain("now")))
    multiplexer.ask(first)
    multiplexer.ask(second)
    turned = event.TaskState("main", "a", "ON", 1.0)
    wire.words = [NumberedResponse(2, request.Done()), turned, NumberedResponse(1, request.Refused(Reason.plain("no")))]
    assert multiplexer.hear() == [(second, request.Done()), turned, (first, request.Refused(Reason.plain("no")))]
    assert multiplexer.readings() == {"main/X": b"1"}


def test_the_same_wish_is_said_once(multiplexer, wire):
    wish = live.Attend(("*",))
    multiplexer.attend(wish)
    multiplexer.attend(live.Attend(("*",)))
    multiplexer.attend(live.Attend(("*",), ("main/X",)))
    wire.words = [NumberedResponse(1, request.Done())]
    assert len(wire.sent) == 2 and multiplexer.hear() == []


def test_figures_are_asked_for_twice_a_second_and_never_twice_at_once(multiplexer, wire, now):  # R-A11
    assert multiplexer.poll_figures(is_wanted=False) is None and wire.sent == []
    multiplexer.poll_figures(is_wanted=True)
    now[0] = 9.0
    multiplexer.poll_figures(is_wanted=True)
    assert wire.sent == [live.Status()]
    wire.words = [NumberedResponse(1, FIGURES)]
    assert multiplexer.hear() == [] and multiplexer.figures is FIGURES
    assert multiplexer.poll_figures(is_wanted=True) is None and len(wire.sent) == 2
    wire.words = [NumberedResponse(2, request.Refused(Reason.plain("no")))]
    multiplexer.hear()
    assert multiplexer.figures is None
    assert multiplexer.poll_figures(is_wanted=True) == pytest.approx(0.5)
    now[0] = 9.5
    assert multiplexer.poll_figures(is_wanted=True) is None and len(wire.sent) == 3


def test_orders_that_get_no_reply_any_more_are_refused_with_the_reason(multiplexer, wire):  # R-E10
    order = Order(live.Survey())
    multiplexer.ask(order)
    wire.words = [LinkLost(LossCause.CLOSED, Reason.plain("it is gone"))]
    with pytest.raises(LinkLost):
        multiplexer.hear()
    assert multiplexer.orphans(Reason.plain("it is gone")) == [(order, request.Refused(Reason.plain("it is gone")))]
    assert multiplexer.orphans(Reason.plain("it is gone")) == []


def test_it_is_owed_something_until_all_that_was_asked_is_answered(multiplexer, wire):
    assert not multiplexer.is_owed
    multiplexer.ask(Order(live.Survey()))
    assert multiplexer.is_owed
    wire.words = [NumberedResponse(1, request.Done())]
    multiplexer.hear()
    assert not multiplexer.is_owed
    multiplexer.poll_figures(is_wanted=True)
    assert multiplexer.is_owed
