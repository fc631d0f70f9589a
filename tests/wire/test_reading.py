import pytest

from onika.wire import reading

READINGS = [reading.Variable(5, 7, [1.0, 2.0]), reading.Poses(5, b"\x00\x01", ("lamp",))]


@pytest.mark.parametrize("message", READINGS, ids=lambda message: type(message).__name__)
def test_a_reading_travels_whole(message):  # R-C14
    assert reading.decode(reading.encode(message)) == message


def test_every_reading_is_tried():
    assert {type(message) for message in READINGS} == set(reading.Reading.__args__)
