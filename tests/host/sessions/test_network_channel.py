import pytest

from onika.host.sessions.network_channel import NetworkChannel
from onika.link.caller import Role
from onika.link.token import digest
from onika.wire import holding, request
from onika.words.reason import Reason

S = 1_000_000_000


class Listener:
    """A listener whose process does what the test says."""

    def __init__(self, settings):
        self.settings = settings
        self.address = f"ws://{settings.host}:{settings.port or 4711}"
        self.post = object()
        self.is_open = self.is_left = self.is_closed = self.is_gone = False
        self.wrong = None

    def look(self):
        if self.wrong is not None:
            raise OSError(self.wrong)
        return self.is_open

    def leave(self):
        self.is_left = True

    def close(self):
        self.is_closed = True


class Server:
    """Who serves those that come in."""

    def __init__(self):
        self.addresses = ()
        self.launcher = "me"
        self.dismissed = []

    def welcome(self, listener):
        self.addresses = (listener.address,)

    def dismiss(self, reason):
        self.addresses = ()
        self.dismissed.append(reason.key)


class Bench:
    def __init__(self):
        self.server, self.launched, self.answers, self.now = Server(), [], [], 0
        self.channel = NetworkChannel(self.server, self._launch, lambda: self.now)

    def _launch(self, settings):
        self.launched.append(Listener(settings))
        return self.launched[-1]

    def open(self, place="127.0.0.1:0", **more):
        self.channel.open(holding.Listen(place, **more), self.answers.append)

    def opened(self, **more):
        self.open(**more)
        self.launched[-1].is_open = True
        self.channel.serve()
        return self.answers[-1]

    def close(self):
        self.channel.close(self.answers.append)
        return self.answers[-1]

    @property
    def refusal(self):
        (answer,) = self.answers[-1:]
        assert isinstance(answer, request.Refused)
        return answer.reason


@pytest.fixture
def bench(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return Bench()


def test_it_is_closed_until_it_is_opened_and_the_answer_comes_when_it_listens(bench):  # R-A16
    bench.open()
    assert (bench.answers, bench.channel.readers()) == ([], [bench.launched[0].post])
    bench.channel.serve()
    assert (bench.answers, bench.server.addresses) == ([], ())
    bench.launched[0].is_open = True
    bench.channel.serve()
    (answer,) = bench.answers
    assert (answer.addresses, bench.server.addresses) == (("ws://127.0.0.1:4711",), ("ws://127.0.0.1:4711",))
    assert (bench.channel.readers(), bench.channel.due_ns()) == ([], None)


def test_the_token_that_is_told_is_made_for_this_opening_and_only_its_digest_goes_on(bench):  # R-A16
    first = bench.opened(role="operator")
    (user,) = [user for user in bench.launched[0].settings.users if user.name == "guest"]
    assert (user.role, user.digest) == (Role.OPERATOR, digest(first.token))
    assert first.token_at.endswith("token")
    assert first.token not in str(bench.launched[0].settings)
    bench.close()
    assert bench.opened().token != first.token
    (user,) = [user for user in bench.launched[1].settings.users if user.name == "guest"]
    assert user.role is Role.VIEWER


def test_it_is_opened_once(bench):  # R-A16
    bench.open()
    bench.open("127.0.0.1:1")
    assert bench.refusal.key == "host.listens_already"
    bench.launched[0].is_open = True
    bench.channel.serve()
    bench.open("127.0.0.1:1")
    assert (bench.refusal.key, len(bench.launched)) == ("host.listens_already", 1)


@pytest.mark.parametrize(
    ("place", "more", "key"),
    [
        ("127.0.0.1:0", {"role": "king"}, "host.role_unknown"),
        ("127.0.0.1:many", {}, "host.channel_not_opened"),
        ("0.0.0.0:0", {}, "host.channel_not_opened"),
        ("0.0.0.0:0", {"certificate": "no.pem", "key": "no.key", "users": "nobody"}, "host.channel_not_opened"),
    ],
)
def test_what_is_missing_is_told_and_nothing_is_opened(bench, place, more, key):  # R-A16, R-X12
    bench.open(place, **more)
    assert (bench.refusal.key, bench.launched, bench.server.addresses) == (key, [], ())


def test_a_place_that_cannot_be_had_is_told_and_another_one_may_be_tried(bench):  # R-A16
    bench.open()
    bench.launched[0].wrong = Reason.plain("it is taken")
    bench.channel.serve()
    assert (str(bench.refusal), bench.launched[0].is_left) == ("it is taken", True)
    assert bench.opened().addresses


def test_a_process_that_never_listens_is_given_up(bench):  # R-A16
    bench.open()
    assert bench.channel.due_ns() == 20 * S
    bench.now = 20 * S - 1
    bench.channel.serve()
    assert bench.answers == []
    bench.now += 1
    bench.channel.serve()
    assert (bench.refusal.key, bench.launched[0].is_left) == ("host.porter_not_started", True)


def test_closed_again_nobody_comes_in_and_who_was_inside_is_told(bench):  # R-A16
    bench.opened()
    assert isinstance(bench.close(), request.Done)
    assert (bench.server.addresses, bench.server.dismissed) == ((), ["host.channel_closed"])
    listener = bench.launched[0]
    assert (listener.is_left, listener.is_closed, bench.channel.due_ns()) == (True, False, 2 * S)
    assert isinstance(bench.close(), request.Refused)
    assert bench.refusal.key == "host.listens_nowhere"
    listener.is_gone = True
    bench.channel.serve()
    assert (listener.is_closed, bench.channel.due_ns()) == (False, None)


def test_a_process_that_does_not_end_is_ended(bench):  # R-A16, R-X24
    bench.opened()
    bench.close()
    bench.now = 2 * S
    bench.channel.serve()
    assert (bench.launched[0].is_closed, bench.channel.due_ns()) == (True, None)


def test_the_only_way_in_is_not_closed(bench):  # R-A16
    bench.opened()
    bench.server.launcher = ""
    bench.close()
    assert (bench.refusal.key, bench.server.dismissed) == ("host.only_way_in", [])


def test_what_was_opened_at_the_start_can_be_closed(bench):  # R-A16
    listener = bench._launch(bench.opened() and bench.launched[0].settings)
    other = Bench()
    other.channel.adopt(listener)
    other.server.addresses = (listener.address,)
    assert isinstance(other.close(), request.Done)
    assert listener.is_left


def test_one_that_ended_by_itself_gives_way_to_another(bench):  # R-A16
    bench.opened()
    bench.server.addresses = ()  # its end was noticed
    assert bench.close() and bench.refusal.key == "host.listens_nowhere"
    assert bench.opened().addresses
    assert bench.launched[0].is_left


def test_at_the_end_of_the_runtime_nobody_listens_for_it_any_more(bench):  # R-X24
    bench.open()
    bench.channel.finish()
    assert bench.launched[0].is_closed
