import pytest

from onika.desk.environment.reconcile.runtime_rest import RuntimeRest


class Runtime:
    def __init__(self):
        self.asked = []
        self.may_rest = True

    def rest(self):
        self.asked.append("rest")
        return self.may_rest

    def wake(self):
        self.asked.append("wake")


@pytest.fixture
def runtime():
    return Runtime()


@pytest.fixture
def rest():
    rest = RuntimeRest()
    rest.is_wished = True
    return rest


def test_a_runtime_rests_until_anything_comes(rest, runtime):  # R-X25
    rest.lie_down(runtime, is_busy=False)
    rest.lie_down(runtime, is_busy=False)
    assert rest.goes_on
    rest.end(runtime)
    rest.end(runtime)
    assert not rest.goes_on
    assert runtime.asked == ["rest", "wake"]


def test_who_waits_for_it_keeps_it_awake(rest, runtime):
    rest.lie_down(runtime, is_busy=True)
    assert not rest.goes_on and runtime.asked == []


def test_without_a_wish_nothing_rests(rest, runtime):
    rest.is_wished = False
    rest.lie_down(runtime, is_busy=False)
    assert runtime.asked == []


@pytest.mark.parametrize("other", [None, object()])
def test_what_cannot_rest_goes_on(rest, other):
    rest.lie_down(other, is_busy=False)
    assert not rest.goes_on
    rest.end(other)


def test_a_robots_runtime_says_no(rest, runtime):
    runtime.may_rest = False
    rest.lie_down(runtime, is_busy=False)
    assert not rest.goes_on
    rest.end(runtime)
    assert runtime.asked == ["rest"]
