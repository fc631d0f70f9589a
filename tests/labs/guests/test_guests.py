"""The shipped guest and what stands for it: the task that keeps it, and an expert of one rule."""

import pytest

from onika.guest import Errand, GuestError
from onika.labs.guests.expert import Expert
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.fake_partner import FakePartner, wait

KEEPER = shipped() / "guests" / "module" / "guest.py"


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


def keeper(outsider, patience=20.0):
    local = {"GUEST": "expert", "PARTNER": outsider.address, "PATIENCE": patience}
    return Bench(KEEPER, frequency=2, local=local, is_synchronous=True).init().on().cycle()


def test_the_keeper_asks_again_and_again_whether_the_guest_is_there(outsider):  # R-A20
    bench = keeper(outsider)
    call = outsider.accept()
    for _ in range(3):
        question = call.read()
        assert question["ask"] == "hello"
        call.answer(question, guest="expert", actions=[])
        bench.event()
        assert bench.state is State.ON
        bench.cycle()


@pytest.mark.parametrize(
    ("answer", "why"),
    [
        ({"guest": "augur"}, "expected the guest expert, found augur"),
        ({"guest": 5}, "guest"),
        ({}, "guest"),
        ({"error": "no"}, "partner expert: it says: no"),
    ],
)
def test_somebody_else_in_its_place_is_an_error(outsider, answer, why):  # R-A20
    bench = keeper(outsider)
    call = outsider.accept()
    call.answer(call.read(), **answer)
    bench.event()
    assert bench.state is State.ERROR
    assert why in str(bench.why)


def test_a_guest_that_says_nothing_is_an_error_at_the_end_of_patience(outsider):  # R-A20, R-X12
    bench = keeper(outsider, patience=0.01)
    call = outsider.accept()
    call.read()
    assert bench.task is not None
    with pytest.raises(Exception, match="no answer within"):
        wait(bench.task.module.partner)


def test_a_guest_that_is_gone_is_an_error(outsider):  # R-A20, R-X12
    bench = keeper(outsider)
    call = outsider.accept()
    call.read()
    call.close()
    bench.event()
    assert bench.state is State.ERROR
    assert "partner expert: it ended the connection before it answered" in str(bench.why)


# The expert


def errand(name, **fields):
    return Errand(name, "flow1/asks", fields.get("target", {}), fields.get("values", {}))


def taught(goal):
    expert = Expert()
    expert.learn(errand("learn", target={"goal": goal}))
    return expert


def built(expert, lamp=1):
    flows = []
    loop = True
    while loop:
        flows.append(expert.which(errand("which")).flow)
        loop = expert.judge(errand("judge", values={"LAMP": lamp})).loop
    return flows


def test_it_finds_the_order_whatever_the_order_of_the_clauses():  # R-A20
    assert built(taught("cross on square, triangle on waves, square on triangle")) == [0, 1, 2]
    assert built(taught("triangle on cross, cross on square, square on waves")) == [1, 2, 0]
    assert built(taught("square on waves"), lamp=0) == [1]


@pytest.mark.parametrize(
    ("goal", "words"),
    [
        ("cross on square, square on cross", "nothing leads from the box with the waves"),
        ("cross on square", "nothing leads from the box with the waves to that with the cross"),
        ("cross beside square", "expected clauses as"),
        ("cross on moon", "found 'cross on moon'"),
        ("waves on cross", "expected clauses as"),
        ("cross on waves, cross on square", "found 'cross on square'"),
        ("", "expected clauses as"),
    ],
)
def test_a_goal_that_cannot_be_is_refused_with_words(goal, words):  # R-A20
    with pytest.raises(GuestError, match=words):
        taught(goal)


def test_it_expects_the_lamp_at_the_end_of_a_whole_tower():  # R-A20
    with pytest.raises(GuestError, match="the lamp is dark"):
        built(taught("cross on square, triangle on waves, square on triangle"), lamp=0)


def test_without_a_goal_it_knows_nothing_to_choose():  # R-A20
    with pytest.raises(GuestError, match="learn a goal first"):
        Expert().which(errand("which"))


def test_it_says_what_stands_and_what_is_to_come():  # R-A20
    expert = taught("square on triangle, triangle on waves")
    assert expert.report(errand("report")).says == "waves stands, then triangle < square"
    built(expert)
    assert expert.report(errand("report")).says == "waves < triangle < square stands"
