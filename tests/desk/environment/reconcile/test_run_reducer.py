import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job, joints
from onika.wire import act, event, live, request, steer
from onika.wire.view import ShowStep
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def lines(play):
    return [(say.level, str(say.text), say.where) for say in play.says]


def test_the_end_is_said_as_a_success_or_with_its_cause(play):  # R-E14, R-G06
    doc = play.open([job("aC")])
    play.run(doc)
    play.began(0)
    play.done(0)
    play.end(runtime_s=12.34)
    assert lines(play)[-1] == ("success", "play is done: 1 action in 12.3 s", None)
    play.run(doc)
    play.end("aborted by the user")
    assert lines(play)[-1] == ("error", "play was aborted after 0 actions: aborted by the user", None)


def test_a_standstill_is_said_with_its_step(play):  # R-X06
    play.run(play.open([job("aC"), job("bC")]))
    choices = (("clear", Reason.plain("repeats it")),)
    why = ("flow0", "b", "bC", 1, "play.appl:2", Reason.plain("no glass"), "b.py", 7, (), (), choices, 2.0)
    play.tell(event.Explained(*why))
    assert lines(play)[-1] == ("error", "flow0/b: no glass", ShowStep(2))
    assert str(play.view.stops["flow0"].text) == "no glass"
    play.moved("clearing")
    assert play.view.stops == {}


def test_an_end_that_is_explained_stays(play):  # R-X06
    play.run(play.open([job("aC")]))
    play.tell(event.Explained("", "", "", -1, "", Reason.plain("rt0 is gone"), "", 0, (), (), (), 2.0, "lost"))
    play.end("rt0 is gone")
    assert play.view.stops[""].kind == "lost"


def test_warnings_are_noted_and_old_ones_forgotten(play):  # R-E11
    play.run(play.open([job("aC")]))
    for number in range(70):
        play.tell(event.Warned("flow0", "a", Reason.plain(f"odd {number}"), 1.0))
    assert str(play.view.notes[-1]) == "a: odd 69" and len(play.view.notes) == 60
    assert ("warning", "a: odd 69", None) in lines(play)


def test_that_a_task_asks_is_shown_as_its_question_only(play):  # R-E15
    play.run(play.open([job("aC")]))
    file = play.environment.model.run.plan.flows[0].actions[0].place
    place = Reason.of("engine.action_at", file=file, line="1", action="aC")
    where = Reason.of("engine.name_at", place=place, name="a")
    play.tell(event.Warned("flow0", "", Reason.of("engine.asks", where=where), 1.0))
    play.tell(event.Warned("flow0", "", Reason.of("engine.left_by_user", place=place), 1.0))
    assert [str(note) for note in play.view.notes] == ["“a job”: left by the user"]


def test_a_question_offers_where_things_stand(play):  # R-C13, R-E15
    play.run(play.open([job("aC")]))
    play.tell(
        event.Asked(
            "flow0",
            "a",
            Reason.plain("too far"),
            (event.Item("place", "double", 1, "m", "where to", None, None, None),),
            1.0,
        )
    )
    ask = play.view.asks["flow0/a"]
    assert (str(ask.reason), ask.items[0].name, ask.items[0].unit) == ("too far", "place", "m")
    play.tell(event.TaskState("flow0", "a", "ON", 1.5))
    assert play.view.asks == {}


def test_where_flows_are_is_asked_where_one_can_go_round(play):  # R-E05
    play.run(play.open([job("aC"), job("bC")]))
    play.began(0)
    assert play.carried(steer.Who) == []
    play.end()
    ends = [
        job("aC", "Complete job", "WHILETAG    round", "WHILETEST   no"),
        job("bC", "Complete job", "WHILETAG    round", "WHILETEST   yes"),
    ]
    play.run(play.open(ends, name="again"))
    play.runtime.positions = (steer.Position("flow0", "running", 0, is_pausing=True, loops=("round",)),)
    play.began(0)
    assert (play.view.flows["flow0"].loops, play.view.flows["flow0"].is_pausing) == (("round",), True)


def test_worlds_that_a_run_opens_are_seen(play):  # R-K05
    play.run(play.open([job("aC")]))
    count = len(play.carried(live.Survey))
    play.began(0)
    play.began(0)
    assert len(play.carried(live.Survey)) == count + 1


def test_a_runtime_that_is_lost_aborts_the_run(play):  # R-E10
    play.run(play.open([job("aC")]))
    play.began(0, at_s=4.0)
    play.lose("the cable")
    assert (play.view.state, str(play.view.cause), play.view.took_s) == ("over", "the runtime is lost: the cable", 4.0)
    assert not play.view.is_completed


def test_a_runtime_that_is_lost_before_the_run_began_refuses_it(play):  # R-E10
    play.connected("a")
    doc = play.open([job("aC")])
    given = []
    play.is_held_back = True
    play.environment.do(act.Run(doc, confirmed=True), "me", given.append)
    survey = play._waiting.popleft()
    play.environment.replied(survey, play.runtime.ask(survey.asked))
    play.environment.replied(play._waiting.popleft(), live.Accepted(7))
    play.lose("the cable")
    assert "the cable" in str(given[0].no.reason) and play.environment.tree.run is None


def test_target_durations_are_shown(play):  # R-E11
    play.files.task(
        "a",
        "MODULE a\nDESC a\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR A\nTASKTYPE periodic\nFREQ 10\n\n"
        "ONIKA\nOBJECT Joint job",
    )
    play.run(play.open([job("aC", "Joint job"), joints("home", *[0.0] * 6, duration=2.5)]))
    play.began(0)
    assert play.view.flows["flow0"].should_take_s == 2.5 and play.view.flows["flow0"].action == "a job a target"
    assert play.carried(request.Prepare)[0].targets[0].kind == "joint object"
