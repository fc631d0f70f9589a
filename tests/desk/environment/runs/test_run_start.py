from dataclasses import replace

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.run_state.run import RunPart
from onika.desk.environment.runs.run_start import aborts
from onika.wire import request


def test_a_run_is_ended_by_one_wish_at_each_station(tmp_path):  # R-E12
    play = RunFixture(tmp_path)
    play.run(play.open([job("bC")], [job("cC")], parallel=True))
    run = play.environment.model.run
    assert [wish.subsystem for wish in aborts(run)] == ["flow0"]
    apart = replace(run, parts=(RunPart("cmu", (1,)), RunPart("", (0,))))
    assert [wish.subsystem for wish in aborts(apart)] == ["flow1", "flow0"]
    assert all(isinstance(wish, request.Abort) for wish in aborts(apart))
