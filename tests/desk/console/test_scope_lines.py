import csv
import struct

import pytest

from onika.wire.samples import Sampled, SampleStretch, SampleTrace
from onika.words.reason import Reason

MS = 1_000_000


class Scoped:
    """Answers as a runtime in which a task counts 500 times a second, and a number of values are lost once."""

    def __init__(self, runtime, lost=0):
        self.runtime = runtime
        self.lost = lost
        self.number = 1
        self.gone = False

    def ask(self, message):
        if self.gone:
            why = Reason.of("host.not_sampled_there", name="Q_MEZ")
            return Sampled(0, tuple(SampleTrace(name, reason=why) for name in message.variables))
        until = int(self.runtime.now_s * 500) + 1
        traces = []
        for name, after in zip(message.variables, message.after, strict=True):
            first = after + 1 + (self.lost if after == 1 else 0)
            count = max(until - first + 1, 0)
            values = struct.pack(f"{count}d", *range(first, first + count))
            stretches = (SampleStretch(first, first * 2 * MS, 2 * MS, count),) if count else ()
            traces.append(SampleTrace(name, "double", stretches, values))
        return Sampled(until * 2 * MS, tuple(traces))


@pytest.fixture
def scoped(sit):
    def begin(lost=0):
        sitting = sit()
        sitting.does("spawn puma")
        sampled = sitting.runtime.sampling = Scoped(sitting.runtime, lost)
        return sitting, sampled

    return begin


def test_every_value_of_the_seconds_is_written(scoped, tmp_path):  # R-C14
    sitting, _ = scoped()
    path = tmp_path / "q.csv"
    assert sitting.does(f"scope {path} 1 Q_MEZ left/Q_MEZ") == [f"{path}: 1002 values"]
    head, *rows = list(csv.reader(path.read_text().splitlines()))
    assert head == ["t_s", "main/Q_MEZ", "left/Q_MEZ"]
    assert [float(row[1]) for row in rows] == [float(k) for k in range(1, 502)]
    assert rows[1][0] == "0.002000"


def test_values_that_were_lost_are_told_with_their_number(scoped, tmp_path):  # R-C14
    sitting, _ = scoped(lost=7)
    lines = sitting.does(f"scope {tmp_path}/q.csv 0.5 Q_MEZ")
    assert lines[1] == "main/Q_MEZ: 7 values were written over before anybody looked"


def test_what_cannot_be_shown_is_told_and_nothing_is_written(scoped, tmp_path):
    sitting, sampled = scoped()
    assert "seconds" in str(sitting.fails(f"scope {tmp_path}/q.csv soon Q_MEZ").reason)
    many = " ".join(f"V{k}" for k in range(17))
    assert "16" in str(sitting.fails(f"scope {tmp_path}/q.csv 1 {many}").reason)
    sampled.gone = True
    fault = sitting.fails(f"scope {tmp_path}/q.csv 1 Q_MEZ")
    assert fault.reason.key == "host.not_sampled_there"
    assert str(fault.instead) == "nothing is written"
    assert list(tmp_path.iterdir()) == []
