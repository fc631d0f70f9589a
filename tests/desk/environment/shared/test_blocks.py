import gzip
import struct

import numpy as np
from hypothesis import given, strategies as st

from kit.desk.film_reader import FilmReader
from onika.desk.environment.shared.blocks import Blocks


def read(blocks, number):
    head = b'{"instants":0,"blocks":%s}' % str(blocks.places).replace("'", '"').encode()
    return FilmReader(gzip.compress(struct.pack("<Q", len(head)) + head + bytes(blocks.content))).block(number)


@given(st.lists(st.floats(), min_size=2, max_size=24))
def test_numbers_come_back_bit_by_bit(numbers):  # R-X21: 50 instants equal the recording
    rows = np.array(numbers[: len(numbers) // 2 * 2]).reshape(2, -1)
    blocks = Blocks()
    blocks.add(rows, "f8")
    with np.errstate(over="ignore"):
        short = rows.astype(np.float32)
    blocks.add(short, "f4")
    assert np.array(read(blocks, 0)).tobytes() == rows.tobytes()
    np.testing.assert_array_equal(np.array(read(blocks, 1)), short)


def test_what_stays_as_it_is_costs_nothing():  # R-X21: at most 5 MB
    blocks = Blocks()
    blocks.add(np.full((3, 10_000), 0.1), "f8")
    assert len(gzip.compress(bytes(blocks.content))) < 1000


def test_bytes_stand_as_they_are():
    blocks = Blocks()
    blocks.add_bytes(b"abc")
    number = blocks.add_bytes(b"de")
    place = blocks.places[number]
    assert bytes(blocks.content[place["at"] : place["at"] + place["columns"]]) == b"de"
