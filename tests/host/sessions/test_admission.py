import pytest

from onika.host.sessions.admission import (
    BACK_OFF_NS,
    FROM_ONE_ADDRESS,
    IN_THE_DOOR,
    WRONG_TOKENS,
    Admission,
    LetIn,
    TurnedAway,
)
from onika.host.sessions.users import User, Users
from onika.link.caller import Role
from onika.link.channel import Channel
from onika.link.token import digest

ANN = User("ann", Role.OPERATOR, digest("anns"))
HOST, BEARER = ("Host", "robot:7994"), ("Authorization", "Bearer anns")


@pytest.fixture
def door():
    return Admission(Users((ANN,)), ("Robot",), is_private=True)


def status(door, *headers, path="/", address="a", now=0):
    answer = door.judge(path, headers, address, now)
    return answer.status if isinstance(answer, TurnedAway) else 101


@pytest.mark.parametrize(
    ("path", "channel"),
    [("/", Channel.ALL), ("/session", Channel.SESSION), ("/signal", Channel.SIGNAL), ("/stream", Channel.STREAM)],
)
def test_the_path_says_the_channel_and_the_token_who_it_is(door, path, channel):
    assert door.judge(path, (HOST, BEARER), "a", 0) == LetIn(ANN, channel)


@pytest.mark.parametrize(
    ("host", "refusal"),
    [("robot", 101), ("ROBOT:1", 101), ("192.0.2.1:7994", 101), ("[::1]:7994", 101), ("evil.example", 403), ("", 403),
     ("robot.evil.example", 403), ("a:b", 403)],
)  # fmt: skip
def test_only_its_own_names_and_numbers_are_answered_to(door, host, refusal):  # network.md, DNS rebinding
    assert status(door, ("Host", host), BEARER) == refusal


def test_a_request_without_a_host_or_with_two_is_refused(door):
    assert status(door, BEARER) == 403
    assert status(door, HOST, HOST, BEARER) == 403


@pytest.mark.parametrize(
    ("origin", "refusal"),
    [("https://robot:7994", 101), ("http://robot:7994", 403), ("https://robot", 403), ("null", 403)],
)
def test_a_page_of_another_origin_has_no_access(door, origin, refusal):
    assert status(door, HOST, BEARER, ("Origin", origin)) == refusal


@pytest.mark.parametrize("value", ["Bearer wrong", "Bearer ", "Bearer", "Basic anns", "anns", ""])
def test_a_wrong_token_is_told_apart_from_a_wrong_page(door, value):
    assert status(door, HOST, ("Authorization", value)) == 401
    assert status(door, HOST, BEARER, BEARER) == 401
    assert status(door, HOST, BEARER, path="/elsewhere") == 404


def test_ten_wrong_tokens_bar_an_address_for_a_minute_and_no_other():
    door = Admission(Users((ANN,)), ("robot",), is_private=False)
    assert {status(door, HOST) for _ in range(WRONG_TOKENS)} == {401}
    assert status(door, HOST) == 429
    assert status(door, HOST, address="b") == 401
    assert status(door, HOST, now=BACK_OFF_NS - 1) == 429
    assert status(door, HOST, now=BACK_OFF_NS) == 401


def test_who_has_a_right_token_comes_in_whatever_others_of_his_machine_have_tried():  # R-F01
    door = Admission(Users((ANN,)), ("robot",), is_private=False)
    assert {status(door, HOST) for _ in range(5 * WRONG_TOKENS)} == {401, 429}
    assert status(door, HOST, BEARER) == 101


def test_a_right_token_forgives_the_wrong_ones(door):
    for _ in range(3):
        assert {status(door, HOST) for _ in range(WRONG_TOKENS - 1)} == {401}
        assert status(door, HOST, BEARER) == 101


def test_who_stands_longest_in_the_door_makes_room(door):  # network.md F15
    first, evicted = door.enter("a")
    assert evicted is None
    others = [door.enter("a") for _ in range(FROM_ONE_ADDRESS - 1)]
    assert [access for _, access in others if access is not None] == []
    assert door.enter("a")[1] == first
    assert door.enter("b")[1] is None


def test_who_is_in_stands_in_nobodys_way(door):
    numbers = [door.enter("a")[0] for _ in range(FROM_ONE_ADDRESS)]
    for number in numbers:
        door.leave(number)
    assert door.enter("a")[1] is None


def test_there_is_a_limit_for_all_addresses_together(door):
    evicted = [door.enter(str(number))[1] for number in range(IN_THE_DOOR + 1)]
    assert evicted == [None] * IN_THE_DOOR + [1]
