import select
from time import monotonic, monotonic_ns

import numpy as np
import pytest

from kit.record.recording_builder import run
from onika.desk.run.run_review import Review
from onika.host.recording.black_box_holder import HolderProcess, InProcessHolder
from onika.host.recording.black_box_orders import CloseBlackBox, OpenBlackBox
from onika.host.recording.last_seconds import TracedVariables
from onika.host.recording.recorded_variable import places_of
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.words.shape import Shape

WORDS = {"completed": "no", "cause": "it fell", "hash": "", "outside": ""}


def held(holder, path):
    """A run of which five values were written."""
    table = Table(Segment.create("test", 1 << 20))
    table.entry("X", Shape.parse("double"))
    now = monotonic_ns()
    holder.open(OpenBlackBox(1, str(path), now, 2_000_000), run())
    holder.take(TracedVariables("flow0", places_of(table, 0, {})), 1, table.segment)
    for number in range(5):
        table.ring("X").write(np.array([number], dtype=float).tobytes())
    holder.look(now + 1_000_000)
    return table


def word(holder):
    until = monotonic() + 30
    while monotonic() < until:
        words = holder.written()
        if words:
            return words[0]
        select.select(holder.readers(), [], [], 0.05)
    raise TimeoutError("no word")


@pytest.mark.parametrize("kind", [InProcessHolder, pytest.param(HolderProcess, marks=pytest.mark.site)])
def test_what_is_wanted_is_written(tmp_path, kind):  # R-X05
    holder, path = kind(), tmp_path / "a.mcap"
    table = held(holder, path)
    holder.close(CloseBlackBox(1, True, WORDS))
    assert not word(holder).reason
    holder.end()
    with Review(path) as review:
        assert review.series["flow0/X"].at(1 << 62) == table.value("X") == 4.0


@pytest.mark.parametrize("kind", [InProcessHolder, pytest.param(HolderProcess, marks=pytest.mark.site)])
def test_what_is_not_wanted_is_not_written(tmp_path, kind):  # R-X05
    holder, path = kind(), tmp_path / "a.mcap"
    held(holder, path)
    holder.close(CloseBlackBox(1, False, WORDS))
    holder.end()
    assert holder.written() == []
    assert not path.exists()


@pytest.mark.parametrize("kind", [InProcessHolder, pytest.param(HolderProcess, marks=pytest.mark.site)])
def test_it_is_written_as_it_was_described_last(tmp_path, kind):  # R-X05
    holder, path = kind(), tmp_path / "a.mcap"
    held(holder, path)
    holder.describe(1, run(seed=9))
    holder.close(CloseBlackBox(1, True, WORDS))
    assert not word(holder).reason
    holder.end()
    with Review(path) as review:
        assert review.run.begin.seed == 9
