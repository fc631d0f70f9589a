from onika.host.run.status_poll import StatusPoll
from onika.runtime import command, news
from onika.words.reason import Reason


class Sent:
    def __init__(self):
        self.orders = []

    def send(self, rtpu, order):
        self.orders.append((rtpu, order))


def roll_of(*rtpus):
    alive, sent = list(rtpus), Sent()
    return StatusPoll(sent, lambda: alive), sent, alive


def statuses(rtpu, load=0.5):
    return news.Statuses(rtpu, load, ())


def test_all_units_are_asked_and_answer_together():  # R-A11
    status_poll, sent, _ = roll_of("rt1", "rt0")
    came = []
    status_poll.call(came.append)
    assert sent.orders == [("rt0", command.Report()), ("rt1", command.Report())]
    status_poll.hear(statuses("rt1"))
    assert came == []
    status_poll.hear(statuses("rt0", 0.25))
    assert came == [{"rt1": statuses("rt1"), "rt0": statuses("rt0", 0.25)}]
    assert status_poll.loads == {"rt1": 0.5, "rt0": 0.25}


def test_who_asks_meanwhile_gets_the_same_answer_and_counters_begin_once():  # R-A17
    status_poll, sent, _ = roll_of("rt0")
    came = []
    status_poll.call(came.append)
    status_poll.call(came.append)
    assert len(sent.orders) == 1
    status_poll.hear(statuses("rt0"))
    assert len(came) == 2
    status_poll.call(came.append)
    assert len(sent.orders) == 2


def test_a_unit_that_is_lost_is_not_waited_for():  # R-E10
    status_poll, _, alive = roll_of("rt0", "rt1")
    came = []
    status_poll.call(came.append)
    status_poll.hear(statuses("rt0"))
    alive.remove("rt1")
    status_poll.lost()
    assert came == [{"rt0": statuses("rt0")}]
    status_poll.hear(statuses("rt1"))
    assert len(came) == 1


def test_without_any_unit_there_is_an_answer():  # R-E10
    status_poll, _, _ = roll_of()
    came = []
    status_poll.call(came.append)
    assert came == [{}]


def test_an_answer_that_nobody_asked_for_counts_for_nobody():
    status_poll, _, _ = roll_of("rt0")
    came = []
    status_poll.hear(statuses("rt0"))
    status_poll.call(came.append)
    assert came == []


def test_answers_of_a_module_come_in_the_order_of_questions():  # R-A05
    status_poll, sent, _ = roll_of("rt0")
    came = []
    for name in ("a", "b"):
        status_poll.ask("rt0", command.Get("s0", "one", name), lambda reply, name=name: came.append((name, reply)))
    status_poll.ask("rt0", command.Get("s0", "two", "c"), lambda reply: came.append(("c", reply)))
    assert len(sent.orders) == 3
    answers = [
        news.Got("s0", "two", "c", 3),
        news.Got("s0", "one", "a", 1),
        news.Refused("s0", "one", "get or set", Reason.plain("no")),
    ]
    for answer in answers:
        status_poll.answered(answer)
    status_poll.answered(news.Got("s0", "one", "d", 4))
    assert came == list(zip(("c", "a", "b"), answers, strict=True))


def test_a_question_to_a_unit_that_is_lost_is_refused():  # R-E10
    status_poll, _, alive = roll_of("rt0", "rt1")
    came = []
    status_poll.ask("rt0", command.Get("s0", "one", "a"), came.append)
    status_poll.ask("rt1", command.Get("s0", "two", "a"), came.append)
    alive.remove("rt1")
    status_poll.lost()
    status_poll.lost()
    assert came == [news.Refused("s0", "two", "get or set", Reason.of("host.unit_is_gone", name="rt1"))]
    status_poll.answered(news.Got("s0", "one", "a", 1))
    assert came[1:] == [news.Got("s0", "one", "a", 1)]
