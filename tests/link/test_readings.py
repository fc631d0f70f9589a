from onika.link.readings import Readings


def keys(readings, room=10_000, now_ns=0):
    return [(r.key, r.body) for r in readings.take(room, now_ns)]


def test_the_newest_reading_of_a_key_replaces_the_older_one_in_its_turn():
    readings = Readings()
    for key, body in (("a", b"1"), ("b", b"1"), ("a", b"2")):
        readings.put(key, body, 0)
    assert keys(readings) == [("a", b"2"), ("b", b"1")]
    assert keys(readings) == []


def test_a_reading_that_waited_too_long_is_dropped():
    readings = Readings(age_ns=10)
    readings.put("old", b"", 0)
    readings.put("new", b"", 5)
    assert keys(readings, now_ns=11) == [("new", b"")]


def test_no_more_than_the_room_allows_is_taken_and_nothing_without_room():
    readings = Readings()
    for key in "abc":
        readings.put(key, bytes(100), 0)
    assert keys(readings, room=0) == []
    assert [key for key, _ in keys(readings, room=200)] == ["a", "b"]
    assert [key for key, _ in keys(readings, room=200)] == ["c"]


def test_of_too_many_keys_the_one_that_waited_longest_is_dropped():
    readings = Readings(keep=2)
    for key in "abc":
        readings.put(key, b"", 0)
    assert [key for key, _ in keys(readings)] == ["b", "c"]


def test_readings_are_counted_so_that_an_overtaken_one_is_known():
    readings = Readings()
    readings.put("a", b"", 0)
    first = readings.take(1, 0)
    readings.put("a", b"", 0)
    assert first[0].count < readings.take(1, 0)[0].count
