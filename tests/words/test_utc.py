from onika.words.utc import utc


def test_a_time_is_written_to_the_minute_with_its_zone():
    assert utc(0) == "1970-01-01 00:00 UTC"
    assert utc(1_790_000_059.9) == "2026-09-21 14:14 UTC"
