import pytest

from onika.classroom.seat_entrance import KEY_NS, SeatEntrance

HOST = {"host": "127.0.0.1:9001"}


class Time:
    ns = 0

    def __call__(self):
        return self.ns


@pytest.fixture
def time():
    return Time()


@pytest.fixture
def entrance(time):
    return SeatEntrance(("127.0.0.1", "localhost"), 9001, "Ana", is_secure=False, clock=time)


def cookies(entrance, key, *, is_teacher=False):
    entrance.admit(key, is_teacher=is_teacher)
    return {entrance.cookie_name: entrance.enter(key)}


def test_a_key_of_the_class_lets_one_browser_in_once(entrance):  # R-X25
    own = cookies(entrance, "k")
    visitor = entrance.visitor(own)
    assert (visitor.user, visitor.session) == ("Ana", "learner")
    assert entrance.enter("k") is None
    assert entrance.visitor({}) is None
    assert entrance.visitor({entrance.cookie_name: "guess"}) is None


def test_a_key_is_void_after_a_minute(entrance, time):
    entrance.admit("k", is_teacher=False)
    time.ns = KEY_NS
    assert entrance.enter("k") is None


def test_the_cookie_of_another_seat_is_none_here(entrance, time):  # R-X25
    other = SeatEntrance(("127.0.0.1",), 9002, "Ben", is_secure=False, clock=time)
    theirs = cookies(other, "k")
    assert other.visitor(theirs) is not None
    assert entrance.visitor(theirs) is None
    assert entrance.visitor({entrance.cookie_name: theirs[other.cookie_name]}) is None


def test_a_seat_that_goes_to_another_browser_shuts_the_first_one_out_and_keeps_the_teacher(entrance):
    learner, teacher = cookies(entrance, "a"), cookies(entrance, "b", is_teacher=True)
    entrance.admit("waiting", is_teacher=False)
    entrance.shut_out_learner()
    assert entrance.visitor(learner) is None
    assert entrance.enter("waiting") is None
    assert entrance.visitor(teacher).session == "teacher"


def test_only_pages_of_this_very_seat_talk_with_it(entrance):  # R-X25
    assert entrance.is_own_page({**HOST, "origin": "http://127.0.0.1:9001"})
    for origin in ("http://127.0.0.1:9002", "https://127.0.0.1:9001", "null", ""):
        assert not entrance.is_own_page({**HOST, "origin": origin})
    for host in ("127.0.0.1:9002", "evil.example:9001", "127.0.0.1", "", "a b"):
        assert not entrance.is_ours({"host": host})


def test_over_tls_the_cookie_is_for_tls_only(time):
    assert SeatEntrance(("h",), 1, "Ana", is_secure=True, clock=time).cookie_name == "__Host-onika-1"
