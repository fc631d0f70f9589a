import pytest

from kit.labs.laboratory import HOLE, Laboratory, job, joints, target
from onika.store.site import open_site


@pytest.fixture
def laboratory(tmp_path):
    return Laboratory(tmp_path)


@pytest.fixture
def base(tmp_path):
    return open_site([tmp_path], {}, None).directories[0]


def test_a_task_is_read_as_it_was_written(laboratory, base):
    laboratory.plain_task("wink", reads="X", writes="Y Z", hz=12.5, local="GAIN 2\n")
    record, faults = base.task("wink")
    assert faults == ()
    assert (record.task.invar, record.task.outvar, record.task.frequency) == (("X",), ("Y", "Z"), 12.5)
    assert record.task.local[0].words == ("2",)


def test_a_configuration_is_read_as_it_was_written(laboratory, base):
    laboratory.configuration("winkC", "wink 100", "blink 12.5 rt1")
    configuration, faults = base.configuration("winkC")
    assert faults == ()
    assert [(placed.task, placed.frequency, placed.rtpu) for placed in configuration.placed] == [
        ("wink", 100.0, "unknown"),
        ("blink", 12.5, "rt1"),
    ]


def test_an_application_is_read_as_it_was_written(laboratory, base):
    syntax, _ = open_site([], {}, None).syntax()
    first = [job("jmoveC", "Joint job", "SYNCHTAG    meet"), joints("there", 1.0, 2.0, 3.0, 4.0, 5.0, 6.0)]
    laboratory.application("both", first, [job("winkC"), HOLE], parallel=True)
    application, faults = base.application("both", syntax)
    assert faults == ()
    assert application.is_parallel
    move, there = application.flows[0].steps
    assert (move.onikon.name, move.synch_tag) == ("jmoveC", "meet")
    assert there.onikon.values == ((1.0, 2.0, 3.0, 4.0, 5.0, 6.0), (1.0,))
    assert len(application.flows[1].steps) == 2


def test_anything_can_be_planted(laboratory):
    assert "NaN" in laboratory.application("bad", [target("x", "Joint object", "NaN")]).read_text()
    assert laboratory.module("bad", "class (").read_text() == "class ("
