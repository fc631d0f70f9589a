import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, request
from onika.wire.plan import Do, Halt, Jump, Meet


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def program(play, flow=0):
    return play.carried(request.Prepare)[-1].plan.flows[flow].program


def test_a_run_that_ended_is_gone_on_with_where_its_flows_were_redirected_as_they_are_now(play):  # R-K06, R-E09
    play.files.module("a2", '"""The code of a2."""\n')
    play.files.plain_task("a2", writes="A", local="DEVICE other\n")
    doc = play.open([job("aC"), job("aC"), job("aC")])
    play.run(doc)
    play.began(0)
    play.done(0)
    play.moved("paused")
    play.end("enough")
    assert play.view.can_go_on
    play.do(act.Redirect(doc, "", "a", "a2"))
    play.do(act.Run(doc, goes_on=True))
    assert program(play) == (Jump(2), Do(0), Do(1), Do(2), Halt())
    assert [name for name, _ in play.carried(request.Prepare)[-1].plan.flows[0].replaced] == ["a2"]
    play.began(1)
    play.end("once more")
    play.do(act.Redirect(doc, "", "a", ""))
    play.do(act.Run(doc, goes_on=True))
    assert program(play) == (Jump(2), Do(0), Do(1), Do(2), Halt())  # it was under way: it is done again


def test_a_flow_that_waits_at_a_tag_waits_there_again(play):  # R-K06
    meet = "SYNCHTAG m"
    flows = [job("aC"), job("aC", "Complete job", meet)], [job("bC"), job("bC", "Complete job", meet)]
    doc = play.open(*flows, parallel=True)
    play.run(doc)
    play.began(0)
    play.done(0)
    play.moved("waiting", tag="m")
    play.began(0, flow=1)
    play.end("enough")
    play.do(act.Run(doc, goes_on=True))
    assert program(play)[0] == Jump(2)
    assert isinstance(program(play)[2], Meet)
    assert program(play, 1)[0] == Do(0)  # it was under way: done again from the beginning of its flow


def test_there_is_nowhere_to_go_on_before_a_run_has_ended_early_or_in_another_program(play):  # R-K06
    doc = play.open([job("aC"), job("bC")])
    assert play.no(act.Run(doc, goes_on=True)).reason.key == "run.goes_on_not_there"
    play.run(doc)
    play.began(0)
    play.end()
    assert not play.view.can_go_on
    assert play.no(act.Run(doc, goes_on=True)).reason.key == "run.goes_on_not_there"
    play.run(doc)
    play.began(0)
    play.end("enough")
    play.do(act.RemoveIcons(doc, (2,)))
    assert play.no(act.Run(doc, goes_on=True)).reason.key == "run.goes_on_changed"
