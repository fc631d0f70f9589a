import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, request, steer
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_breakpoints_are_set_and_removed_in_the_run_too(play):  # R-D06
    play.files.application("inner", [job("aC"), job("bC")])
    doc = play.open([job("cC"), job("inner", "Complete application")])
    play.run(doc)
    play.do(act.SetBreakpoint(doc, (1,)))
    play.do(act.SetBreakpoint(doc, (1,), condition="C > 1"))
    play.do(act.SetBreakpoint(doc, (2,)))
    play.do(act.SetBreakpoint(doc, (1,), is_set=False))
    assert play.carried(steer.Mark) == [
        steer.Mark("flow0", 0),
        steer.Mark("flow0", 0, True, "C > 1"),
        steer.Mark("flow0", 2),
        steer.Mark("flow0", 0, False),
    ]
    play.end()
    play.do(act.SetBreakpoint(doc, (1,)))
    assert len(play.carried(steer.Mark)) == 4


def test_a_breakpoint_that_comes_too_late_is_said(play):
    doc = play.open([job("aC")])
    play.run(doc)
    play.rebuffs = {steer.Mark: request.Refused(Reason.plain("no application runs"))}
    play.do(act.SetBreakpoint(doc, (1,)))
    assert "from the next run on" in str(play.says[-1].text)
