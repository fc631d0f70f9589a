import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.link.body_parts import BodyAssembly, split
from onika.wire.packet import Part


@settings(max_examples=examples(100), deadline=None)
@given(st.binary(max_size=100), st.integers(1, 30), st.randoms())
def test_a_body_is_whole_again_whatever_the_order_of_its_parts(body, piece, random):  # R-F01
    parts, last = split(7, body, piece)
    assert all(len(part.body) == piece for part in parts)
    assert len(last) <= piece
    assembly = BodyAssembly(limit=100_000)
    heap = [*parts, *parts]
    random.shuffle(heap)
    for part in heap:
        assembly.put(part)
    assert assembly.complete(7, len(parts), last) == body


def test_a_body_with_a_missing_part_is_not_complete():
    parts, last = split(1, b"abcdef", 2)
    assembly = BodyAssembly(limit=1000)
    assembly.put(parts[1])
    assert assembly.complete(1, 2, last) is None
    assembly.put(parts[0])
    assert assembly.complete(1, 2, last) == b"abcdef"


def test_parts_without_end_are_refused_even_when_they_are_empty():
    assembly = BodyAssembly(limit=1000)
    with pytest.raises(ValueError, match="at most"):
        for index in range(1000):
            assembly.put(Part(1, index, b""))


def test_parts_that_were_let_go_make_room():
    assembly = BodyAssembly(limit=1000)
    for number in range(50):
        assembly.put(Part(number, 0, bytes(500)))
        assembly.drop(number)
    assembly.put(Part(1, 0, bytes(500)))
    assembly.clear()
    assembly.put(Part(1, 0, bytes(900)))
    assert assembly.complete(1, 1, b"") == bytes(900)
