import pytest
from hypothesis import given, strategies as st

from onika.cli.keys import Keys


@pytest.mark.parametrize(
    ("data", "keys"),
    [
        (b"ab", ["a", "b"]),
        ("é漢".encode(), ["é", "漢"]),
        (b"\r\n\t", ["enter", "enter", "tab"]),
        (b"\x1b[A\x1bOB\x1b[3~", ["up", "down", "delete"]),
        (b"\x1b[1;5Cx", ["word right", "x"]),
        (b"\x1bb", ["word left"]),
        (b"\x04\x7f\x15", ["delete or end", "backspace", "cut to start"]),
        (b"\x1b[200~a\x1b[999z", ["a"]),
        (b"\x00\x1f", []),
        (b"\xff", ["�"]),
    ],
)
def test_bytes_are_keys(data, keys):
    assert Keys().read(data) == keys


@given(
    st.lists(st.sampled_from([b"a", "漢".encode(), b"\x1b[A", b"\x1b[1;5D", b"\x1bOC", b"\x1bf", b"\x7f"])), st.data()
)
def test_it_does_not_matter_where_they_are_cut(pieces, data):
    whole = b"".join(pieces)
    place = data.draw(st.integers(0, len(whole)))
    keys = Keys()
    assert keys.read(whole[:place]) + keys.read(whole[place:]) == Keys().read(whole)
