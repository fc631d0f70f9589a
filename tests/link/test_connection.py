import pytest

from onika.link.carrier import memory_pair, socket_pair
from onika.link.connection import Connection
from onika.link.link_events import (
    EpochChanged,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    RequestFate,
    RequestReceived,
    Resumed,
    SignalReceived,
)
from onika.link.link_terms import LinkTerms
from onika.link.lost import LinkLost, LossCause
from onika.link.runtime_port import ServerPort
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState
from onika.words.reason import Reason, in_language, reason_of

TERMS = LinkTerms(beat_ns=100_000_000, suspect_ns=500_000_000, lost_ns=2_000_000_000, greeting_ns=3_000_000_000)


class Runtime:
    """A runtime in the same thread: it works whenever the environment waits, and time passes only then."""

    def __init__(self, epoch="e1"):
        self.now_ns = 0
        self.port = ServerPort(SignalJournal(epoch), terms=TERMS)
        self.is_mute = False
        self.asked = []

    def clock(self):
        return self.now_ns

    def wait(self, _carrier, timeout_s):
        self.now_ns += max(1, min(round((timeout_s or 0) * 1e9), 50_000_000))
        if not self.is_mute:
            self.serve()

    def serve(self):
        for news in self.port.service(self.now_ns):
            if isinstance(news, RequestReceived):
                self.asked.append(news.body)
                if news.body != b"think":
                    self.port.reply(news.ticket, b"re: " + news.body, self.now_ns)

    def connect(self):
        here, there = memory_pair()
        self.port.attach(there, self.now_ns)
        return here

    def connection(self):
        return Connection(self.connect(), self.clock, TERMS, wait=self.wait)


def news_of(connection):
    return [news for news in connection.poll() if not isinstance(news, LinkStateChanged)]


def test_a_request_gets_its_answer_and_news_is_kept_for_later():  # R-F01
    runtime = Runtime()
    connection = runtime.connection()
    assert connection.open() == "e1"
    runtime.port.signal(b"s1", 0)
    runtime.port.reading("q", b"1", 0)
    assert connection.request(b"a") == b"re: a"
    runtime.port.reading("q", b"2", 0)
    assert connection.request(b"b") == b"re: b"
    assert news_of(connection) == [EpochChanged("e1"), SignalReceived(1, b"s1"), ReadingReceived("q", b"2")]


def test_the_first_request_may_come_before_the_greeting():
    assert Runtime().connection().request(b"a") == b"re: a"


def test_an_answer_that_does_not_come_in_time_is_a_time_out_and_no_loss():
    runtime = Runtime()
    connection = runtime.connection()
    with pytest.raises(TimeoutError, match="no answer within 1 s") as late:
        connection.request(b"think", timeout_s=1)
    assert in_language(reason_of(late.value), "es") == "no hubo respuesta en 1 s"
    assert connection.state is LinkState.LINKED
    assert connection.request(b"a") == b"re: a"


def test_a_request_that_waited_too_long_on_the_way_is_not_carried_out():  # R-X12
    runtime = Runtime()
    connection = runtime.connection()
    connection.open()
    number = connection.ask(b"go", begin_within_s=0.2, once=True)
    runtime.now_ns += 300_000_000
    runtime.serve()
    assert connection.poll(1)[-1] == RequestFailed(number, RequestFate.LATE)
    assert runtime.asked == []


def test_a_silent_runtime_is_first_suspect_and_then_lost():  # R-F01
    runtime = Runtime()
    connection = runtime.connection()
    connection.open()
    connection.poll()
    runtime.is_mute = True
    with pytest.raises(LinkLost) as caught:
        connection.request(b"a", timeout_s=10)
    assert caught.value.cause is LossCause.SILENT
    assert [news.state for news in connection.poll() if isinstance(news, LinkStateChanged)] == [
        LinkState.SUSPECT,
        LinkState.APART,
    ]
    assert connection.lost is caught.value


def test_a_runtime_that_never_greets_is_given_up():
    runtime = Runtime()
    runtime.is_mute = True
    with pytest.raises(LinkLost, match=r"silent for 3\.0 s"):
        runtime.connection().open(timeout_s=10)


def test_a_greeting_may_be_waited_for_less_long():
    runtime = Runtime()
    runtime.is_mute = True
    with pytest.raises(TimeoutError, match="no greeting within 1 s"):
        runtime.connection().open(timeout_s=1)


def test_a_connection_resumes_where_it_was_cut():  # R-F01
    runtime = Runtime()
    connection = runtime.connection()
    connection.open()
    number = connection.ask(b"a")
    runtime.port.drop()
    runtime.port.signal(b"meanwhile", 0)
    connection.poll()
    assert connection.state is LinkState.APART
    assert connection.readers() == []
    connection.reconnect(runtime.connect())
    connection.open()
    assert connection.poll(1)[-2:] == [Resumed("e1"), SignalReceived(1, b"meanwhile")]
    while not (news := news_of(connection)):
        runtime.wait(None, 0.1)
    assert news == [ReplyReceived(number, b"re: a")]


def test_a_request_over_a_lost_link_fails_at_once():
    runtime = Runtime()
    connection = runtime.connection()
    connection.open()
    runtime.port.drop()
    connection.poll()
    for once in (False, True):
        with pytest.raises(LinkLost, match="the other side closed"):
            connection.request(b"a", once=once)
    assert connection.poll(5) == []


def test_a_link_that_was_closed_here_says_good_bye_and_stays_closed():
    runtime = Runtime()
    connection = runtime.connection()
    connection.open()
    connection.close(Reason.plain("enough"))
    runtime.serve()
    assert not runtime.port.is_open
    with pytest.raises(LinkLost) as caught:
        connection.reconnect(runtime.connect())
    assert caught.value.cause is LossCause.HERE
    with pytest.raises(LinkLost):
        connection.request(b"a")


def test_polling_waits_for_the_first_news_only():
    runtime = Runtime()
    connection = runtime.connection()
    connection.open()
    connection.poll()
    assert connection.poll(0.3) == []
    assert runtime.now_ns >= 300_000_000
    runtime.port.signal(b"s", runtime.now_ns)
    assert connection.poll(1000) == [SignalReceived(1, b"s")]


def test_a_loop_of_ones_own_knows_what_to_wait_for_and_how_long():
    runtime = Runtime()
    here, there = socket_pair()
    runtime.port.attach(there, 0)
    connection = Connection(here, runtime.clock, TERMS, wait=runtime.wait)
    assert connection.readers() == [here.fileno()]
    assert connection.writers() == []
    connection.open()
    assert connection.due_s() is not None
    assert 0 <= connection.due_s() <= 0.1
    connection.close()
    assert connection.due_s() is None
    runtime.port.drop()
