from onika.web.handshake_limit import AT_ONCE, HandshakeLimit

S = 1_000_000_000


def test_an_address_begins_some_at_once_and_then_a_few_a_second():  # R-F10
    limit = HandshakeLimit()

    def begun(now_ns, count=400):
        numbers = [limit.begin("10.0.0.1", now_ns) for _ in range(count)]
        for number, _ in filter(None, numbers):
            limit.end(number)
        return sum(number is not None for number in numbers)

    assert begun(0) == AT_ONCE
    assert begun(0) == 0
    assert begun(S) == 20
    assert begun(100 * S) == AT_ONCE
    assert limit.begin("10.0.0.2", 0) is not None


def test_where_too_many_are_under_way_the_most_crowded_address_makes_room():  # R-F10
    limit = HandshakeLimit(most=4)
    honest, _ = limit.begin("10.0.0.9", 0)
    crowd = [limit.begin("10.0.0.1", 0) for _ in range(10)]
    evicted = [gone for _, gone in crowd if gone is not None]
    assert evicted == [number for number, _ in crowd[: len(evicted)]]
    assert honest not in evicted
    assert len(evicted) == 7


def test_one_that_is_done_takes_no_room():
    limit = HandshakeLimit(most=1)
    first, _ = limit.begin("a", 0)
    limit.end(first)
    limit.end(first)
    assert limit.begin("b", 0) == (2, None)


def test_a_flood_of_addresses_takes_no_room():
    limit = HandshakeLimit()
    for number in range(10_000):
        begun = limit.begin(str(number), 0)
        limit.end(begun[0])
    assert len(limit._free_ns) <= 4097
