import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import HOLE, job
from onika.wire import act, event, live, request, steer
from onika.wire.view import ShowFits, ShowValues
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_a_run_is_prepared_and_begun_with_the_steps_as_lines(play):  # R-E07
    doc = play.open([job("aC"), job("bC")])
    view = play.run(doc)
    assert (view.state, view.number, view.of, list(view.flows)) == ("running", 1, 2, ["flow0"])
    (prepared,) = play.carried(request.Prepare)
    assert [action.spot for action in prepared.plan.flows[0].actions] == [(1,), (2,)]
    (begin,) = play.carried(request.Begin)
    assert (begin.may_ask, begin.on_error, begin.on_loss) == (True, "wait", "stop")
    assert play.environment.tree.applications[doc].is_running


def test_what_becomes_of_it_where_this_environment_is_lost_is_chosen_before(play):  # R-X12
    play.do(act.Run(play.open([job("aC")]), on_loss="run"))
    assert play.carried(request.Begin)[-1].on_loss == "run"


def test_what_is_here_runs_and_not_what_the_file_says(play):  # R-E12
    doc = play.open([job("aC"), job("bC"), job("cC")])
    play.do(act.RemoveIcons(doc, (2,)))
    play.run(doc)
    (prepared,) = play.carried(request.Prepare)
    assert [(action.name, action.spot) for action in prepared.plan.flows[0].actions] == [("aC", (1,)), ("cC", (3,))]


def test_everything_that_is_wrong_is_told_at_once(play):  # R-E01, R-X01
    doc = play.open([job("aC"), HOLE, job("goneC")])
    no = play.no(act.Run(doc))
    assert "an action is missing here" in str(no.reason) and "no configuration goneC" in str(no.reason)
    assert no.remedies[0].show == ShowFits("0", 1)
    assert play.carried_out == []


def test_one_application_runs_once_at_a_time(play):
    doc = play.open([job("aC")])
    play.run(doc)
    no = play.no(act.Run(doc))
    assert str(no.reason) == "play runs already" and no.remedies[0].act == act.Steer("abort", doc)
    play.end()
    assert play.run(doc).number == 2


def test_while_one_begins_no_other_does(play):  # R-C18
    doc, other = play.open([job("aC")]), play.open([job("bC")], name="other")
    given = []
    play.is_held_back = True
    play.environment.do(act.Run(doc), "me", given.append)
    assert "play is about to begin" in str(play.no(act.Run(other)).reason)
    play.is_held_back = False
    play.pump()
    assert given[0].no is None and play.run(other).number == 2


def test_what_is_not_open_or_cannot_be_named_does_not_run(play):
    assert "no longer open" in str(play.no(act.Run("a9")).reason)


def test_a_configuration_that_is_not_saved_is_asked_about(play, tmp_path):  # R-E12
    doc = play.open([job("aC")])
    conf = play.do(act.Open(str(tmp_path / "conf" / "aC.conf")))
    play.do(act.Rate(conf, "a", 50.0))
    no = play.no(act.Run(doc))
    assert "aC is changed here and not saved" in str(no.reason)
    save, as_filed = (remedy.act for remedy in no.remedies)
    play.do(as_filed)
    assert play.carried(request.Prepare)[-1].plan.flows[0].actions[0].rates == (("a", 100.0),)
    play.end()
    play.do(save)
    assert play.carried(request.Prepare)[-1].plan.flows[0].actions[0].rates == (("a", 50.0),)
    assert not play.document(conf).is_dirty


def test_what_stands_in_the_way_is_ended_only_when_the_user_wants_it(play):  # reading 30
    lower = play.connected("a")
    apart = play.new("c")
    play.do(act.Connect(apart, subsystem="apart"))
    doc = play.open([job("aC"), job("bC")])
    no = play.answer(act.Run(doc)).no
    assert str(no.reason).startswith("play needs for itself what lives already: a of Untitled-1. ")
    assert "Untitled-2" not in str(no.reason)
    assert play.environment.tree.run is None and play.carried(live.Close) == []
    play.do(no.remedies[0].act)
    assert play.carried(live.Close) == [live.Close("Untitled-1")]
    assert play.document(lower).live is None and play.state(apart, "c") == "OFF"
    assert play.view.state == "running"


def test_what_cannot_be_ended_is_said_and_nothing_runs(play):  # reading 30
    play.connected("a")
    doc = play.open([job("aC")])
    play.rebuffs = {live.Close: request.Refused(Reason.plain("subsystem Untitled-1 is held by anna#2"))}
    assert "anna#2" in str(play.answer(act.Run(doc, confirmed=True)).no.reason)
    assert play.environment.tree.run is None


def test_an_end_that_is_told_before_it_is_accepted_counts(play):
    play.connected("a")
    doc = play.open([job("aC")])
    given = []
    play.is_held_back = True
    play.environment.do(act.Run(doc, confirmed=True), "me", given.append)
    survey = play._waiting.popleft()
    play.environment.replied(survey, play.runtime.ask(survey.asked))
    close = play._waiting.popleft()
    play.environment.receive(event.Edited("Untitled-1", 99, NOTHING, 1.0))
    play.environment.replied(close, live.Accepted(99))
    play.is_held_back = False
    play.pump()
    assert given[0].no is None and play.view.state == "running"


def test_the_runtimes_own_faults_lead_to_their_step(play, tmp_path):  # R-E01
    doc = play.open([job("aC"), job("bC")])
    file = str(tmp_path / "appl" / "play.appl")
    play.runtime.faults = (
        request.FaultText(
            file,
            2,
            Reason.of("host.values_unfit", task="b", target="bC", why="expected 1 double, found none"),
            Reason.plain(""),
        ),
    )
    no = play.answer(act.Run(doc)).no
    assert "bC does not suit b" in str(no.reason) and no.remedies[0].show == ShowValues(2)
    assert play.environment.tree.run is None


def test_a_stop_has_to_be_left_before_anything_runs(play):  # law 27
    doc = play.open([job("aC")])
    play.runtime.is_stopped = True
    no = play.answer(act.Run(doc)).no
    assert no.remedies[0].act == act.Reset() and play.environment.tree.run is None


def test_a_name_that_is_taken_is_given_to_nobody_else(play):
    busy = play.new("c")
    play.do(act.Connect(busy, subsystem="flow0"))
    doc = play.open([job("aC")])
    assert list(play.run(doc).flows) == ["flow0-1"]
    assert play.carried(request.Prepare)[0].plan.flows[0].subsystem == "flow0-1"


def test_without_a_runtime_the_reason_is_told_and_the_former_run_stays(play):  # R-E10
    doc = play.open([job("aC")])
    play.run(doc)
    play.end()
    play.rebuffs = {live.Survey: request.Refused(Reason.plain("no program"))}
    assert "no program" in str(play.answer(act.Run(doc)).no.reason)
    assert play.view.number == 1 and play.environment.tree.runtime.state == "lost"


def test_a_run_that_the_runtime_will_not_begin_is_refused(play):
    doc = play.open([job("aC")])
    play.rebuffs = {request.Begin: request.Refused(Reason.plain("subsystem flow0 is held by anna#2"))}
    assert "anna#2" in str(play.answer(act.Run(doc)).no.reason)


def test_breakpoints_are_passed_where_the_user_wants_it(play):  # R-D06
    doc = play.open([job("aC"), job("bC")])
    play.do(act.SetBreakpoint(doc, (1,)))
    play.run(doc)
    play.end()
    play.do(act.Run(doc, passes_breakpoints=True))
    marked, passing = (prepared_request.plan.flows[0] for prepared_request in play.carried(request.Prepare))
    assert [action.marker for action in marked.actions] == [True, False]
    assert [action.marker for action in passing.actions] == [False, False] and len(passing.program) < len(
        marked.program
    )


def test_an_application_without_a_file_runs_too(play):  # R-E12
    doc = play.open([job("aC"), job("bC")])
    fresh = play.do(act.NewApplication())
    play.do(act.CopyIcons(doc, (1, 2)))
    play.do(act.PasteIcons(fresh))
    view = play.run(fresh)
    assert view.of == 2 and view.doc == fresh
    play.began(1)
    assert list(play.view.steps) == [str(play.environment.tree.applications[fresh].flows["0"].steps[1])]


def test_what_was_not_saved_before_does_not_speak_of_files(play):  # R-E01
    fresh = play.do(act.NewApplication())
    no = play.no(act.Run(fresh))
    assert "flow 0 is empty" in str(no.reason) and no.remedies[0].show == ShowFits("0", 0)


@pytest.mark.parametrize(("carried", "is_begun"), [(0, False), (1, False), (2, True)])
def test_who_aborts_before_it_has_begun_gets_no_run(play, carried, is_begun):  # R-E07
    doc = play.open([job("aC")])
    given = []
    play.is_held_back = True
    play.environment.do(act.Run(doc), "me", given.append)
    for _ in range(carried):  # the survey, the preparation; then the beginning itself
        order = play._waiting.popleft()
        play.environment.replied(order, play.runtime.ask(order.asked))
    play.environment.do(act.Steer("abort"), "other", lambda _answer: None)
    play.is_held_back = False
    play.pump()
    assert bool(play.carried(request.Begin)) == bool(play.carried(request.Abort)) == is_begun
    assert (given[0].no is None) == is_begun
    assert is_begun or "before it had begun" in str(given[0].no.reason)


@pytest.mark.parametrize("carried", range(3))
@pytest.mark.parametrize(("lines", "pauses"), [(("pause",), 1), (("pause", "continue"), 0)])
def test_who_pauses_before_it_has_begun_gets_a_run_that_pauses_at_once(play, carried, lines, pauses):  # R-E07
    doc = play.open([job("aC")])
    play.is_held_back = True
    play.environment.do(act.Run(doc), "me", lambda _answer: None)
    for _ in range(carried):
        order = play._waiting.popleft()
        play.environment.replied(order, play.runtime.ask(order.asked))
    for line in lines:
        play.environment.do(act.Steer(line), "other", lambda _answer: None)
    play.is_held_back = False
    play.pump()
    assert play.carried(request.Begin)
    assert play.carried(steer.Pause) == [steer.Pause("flow0")] * pauses
