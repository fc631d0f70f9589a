import os
import threading

import pytest

from onika.cli import typed as room
from onika.cli.typed import typed_line


@pytest.fixture
def keys(monkeypatch):
    """Where a user types."""
    read, write = os.pipe()
    with os.fdopen(read) as stdin:
        monkeypatch.setattr("sys.stdin", stdin)
        yield write


def test_a_line_is_read_without_its_end(keys):  # R-A10
    os.write(keys, b"0.5 0.75 \n")
    assert typed_line() == "0.5 0.75 "
    os.close(keys)


def test_an_empty_line_is_an_answer_and_the_end_of_the_input_is_none(keys):  # R-A10
    os.write(keys, b"\n")
    assert typed_line() == ""
    os.close(keys)
    assert typed_line() is None


def test_it_waits_in_turns_until_something_is_typed(keys, monkeypatch):  # R-E07
    turns = []
    select = room.select.select

    def waited(*given):
        turns.append(given)
        if len(turns) == 3:
            threading.Thread(target=os.write, args=(keys, b"at last\n")).start()
        return select(*given[:3], 0.001)

    monkeypatch.setattr(room.select, "select", waited)
    assert typed_line() == "at last"
    assert len(turns) >= 3
    os.close(keys)
