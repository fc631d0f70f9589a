from dataclasses import replace

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.run_state.run import RunPart
from onika.desk.environment.run_state.run_parts import ended, is_ended_at, of_whole
from onika.wire import event
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def run(tmp_path):
    play = RunFixture(tmp_path)
    play.run(play.open([job("bC")], [job("cC")], parallel=True))
    return replace(play.environment.model.run, parts=(RunPart("cmu", (1,)), RunPart("", (0,))))


def result(done, cause="", took_s=1.0):
    return event.Result(not cause, Reason.plain(cause) if cause else NOTHING, done, 2, took_s, 0.0, {}, (), "")


def test_flows_have_the_numbers_of_the_whole_run(run):  # R-E12
    for station, number in (("cmu", 1), ("", 0)):
        assert of_whole(run, event.Began(0, 0, 1, "x", 1.0), station)[1].flow == number
        assert of_whole(run, event.Done(0, 0, 1.0), station)[1].flow == number
    strange = event.Done(7, 0, 1.0)
    assert of_whole(run, strange, "cmu") == (run, strange) and of_whole(run, strange, "far") == (run, strange)


def test_it_is_over_with_its_last_part_and_all_of_them_count(run):  # R-E14, R-E12
    run, end = ended(run, "cmu", result(1, took_s=5.0))
    assert end is None and is_ended_at(run, "cmu") and not is_ended_at(run, "")
    _, end = ended(run, "", result(2))
    assert (end.completed, end.done, end.of, end.runtime_s, end.cause) == (True, 3, 4, 5.0, NOTHING)


def test_a_part_that_failed_is_named_by_its_station(run):  # R-E14, R-E12
    run, _ = of_whole(run, result(1, "it fell"), "")
    _, end = of_whole(run, result(1, "the cable"), "cmu")
    assert not end.completed
    assert str(end.cause).index("cmu: the cable") < str(end.cause).index("the first station: it fell")
