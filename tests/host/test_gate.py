from onika.host.gate import Gate
from onika.link.carrier import memory_pair
from onika.link.connection import Connection
from onika.link.happening import Signalled
from onika.link.journal import Journal
from onika.link.port import ServerPort
from onika.link.terms import CHILD
from onika.wire import event, request


class Pair:
    """A gate and an environment in one thread; the gate answers whenever the environment waits."""

    def __init__(self):
        self.now = 0
        here, there = memory_pair()
        port = ServerPort(Journal("e"), terms=CHILD)
        port.attach(there, 0)
        self.gate = Gate(port, lambda: self.now)
        self.asked = []
        self.connection = Connection(here, lambda: self.now, CHILD, wait=self.serve)
        self.connection.open()

    def serve(self, _carrier, _timeout):
        self.now += 1_000_000
        for ticket, one in self.gate.requests():
            self.asked.append(one)
            self.gate.reply(ticket, request.Done())

    def ask(self, body):
        return request.decode_response(self.connection.request(body))


def test_a_request_comes_out_and_its_response_goes_back():  # R-F01, R-F07
    pair = Pair()
    assert pair.ask(request.encode(request.Abort("enough"))) == request.Done()
    assert pair.asked == [request.Abort("enough")]


def test_what_is_no_request_is_refused_at_once():  # R-F07
    pair = Pair()
    for body in (b"", b"\xc1", b"\x81\xa4type\xa4Nope", request.encode(request.Done())):
        answer = pair.ask(body)
        assert isinstance(answer, request.Refused)
        assert answer.reason.startswith("expected a request")
    assert pair.asked == []


def test_events_arrive_in_their_order():  # R-F01, house decision 7
    pair = Pair()
    said = [event.Done(0, number, number / 2) for number in range(5)]
    for one in said:
        pair.gate.tell(one)
    pair.serve(None, 0)
    heard = [event.decode(one.body) for one in pair.connection.poll() if isinstance(one, Signalled)]
    assert heard == said


def test_it_is_open_until_the_environment_goes():  # R-E10
    pair = Pair()
    assert pair.gate.is_open
    pair.connection.close(timeout_s=0)
    pair.gate.requests()
    assert not pair.gate.is_open
