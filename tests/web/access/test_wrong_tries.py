import pytest

from onika.web.access.wrong_tries import BACK_OFF_NS, MOST, WrongTries

HERE = "10.0.0.1"


@pytest.fixture
def tries():
    return WrongTries()


def spend(tries, count, address=HERE, now=0):
    for _ in range(count):
        tries.note(address, now)


def test_after_ten_wrong_tries_nobody_from_there_is_judged_for_a_minute(tries):  # R-F10
    spend(tries, MOST - 1)
    assert tries.wait_ns(HERE, 0) == 0
    spend(tries, 1)
    assert tries.wait_ns(HERE, 1) == BACK_OFF_NS - 1
    assert tries.wait_ns("10.0.0.2", 1) == 0
    assert tries.wait_ns(HERE, BACK_OFF_NS) == 0


def test_each_one_more_doubles_the_wait_up_to_about_an_hour(tries):
    spend(tries, MOST)
    waits = []
    for _ in range(8):
        spend(tries, 1)
        waits.append(tries.wait_ns(HERE, 0) // BACK_OFF_NS)
    assert waits == [2, 4, 8, 16, 32, 64, 64, 64]


def test_a_right_password_in_between_forgives_itself_alone(tries):  # whoever has an account guesses those of others
    spend(tries, MOST - 1)
    tries.note(HERE, 0)
    tries.take_back(HERE)
    assert tries.wait_ns(HERE, 0) == 0
    spend(tries, 1)
    assert tries.wait_ns(HERE, 0) > 0


def test_what_is_long_past_is_forgotten(tries):
    spend(tries, MOST - 1)
    spend(tries, 1, now=BACK_OFF_NS)
    assert tries.wait_ns(HERE, BACK_OFF_NS) == 0


def test_a_single_right_one_leaves_nothing(tries):
    tries.note(HERE, 0)
    tries.take_back(HERE)
    tries.take_back(HERE)
    spend(tries, MOST - 1)
    assert tries.wait_ns(HERE, 0) == 0


def test_whoever_has_a_network_of_addresses_is_one(tries):  # R-F10
    for number in range(MOST):
        tries.note(f"2001:db8::{number + 1:x}", 0)
    assert tries.wait_ns("2001:db8::ffff%eth0", 0) > 0
    assert tries.wait_ns("2001:db8:0:1::1", 0) == 0


def test_an_address_that_is_mapped_is_the_same(tries):
    spend(tries, MOST, "::ffff:10.0.0.1")
    assert tries.wait_ns(HERE, 0) > 0
    assert tries.wait_ns("no address", 0) == 0


def test_a_flood_of_addresses_takes_no_room(tries):
    for number in range(10_000):
        tries.note(f"10.{number >> 16}.{number >> 8 & 255}.{number & 255}", 0)
    assert len(tries._wrong) <= 4096
