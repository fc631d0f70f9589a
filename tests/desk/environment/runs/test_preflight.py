from dataclasses import replace as replaced

import pytest
from msgspec.structs import replace

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import HOLE, job
from onika.wire import act, request
from onika.words.fault import NOT_RUN
from onika.words.reason import Reason

FAR = (Reason.of("host.unreachable", target="home", why="joint 3 at 9.00 rad is beyond 3.93"), NOT_RUN)


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def path(play):
    return str(play.files.path / "appl" / "play.appl")


def shown(play, doc):
    return play.environment.tree.applications[doc]


def texts(play, doc):
    return {(fault.step, str(fault.text)) for fault in shown(play, doc).faults.values()}


def finds(play, *lines, file=None):
    """Let the runtime find what `FAR` says at these steps."""
    play.runtime.faults = tuple(request.FaultText(file or path(play), line, *FAR) for line in lines)


def test_everything_is_looked_at_and_nothing_begins(play):  # R-X02
    doc = play.open([job("aC"), job("bC")])
    assert play.do(act.Preflight(doc)) == 0
    assert len(play.carried(request.Prepare)) == 1 and play.carried(request.Begin) == []
    assert shown(play, doc).is_checked and play.environment.tree.run is None


def test_what_a_runtime_finds_stands_at_its_steps_until_the_application_changes(play):  # R-X02
    doc = play.open([job("aC"), job("bC")])
    finds(play, 1, 2)
    assert play.do(act.Preflight(doc)) == 2
    sentence = "home cannot be reached: joint 3 at 9.00 rad is beyond 3.93"
    assert texts(play, doc) == {(1, sentence), (2, sentence)}
    assert all(fault.is_of_runtime for fault in shown(play, doc).faults.values())
    play.do(act.SetBreakpoint(doc, (1,)))
    assert len(texts(play, doc)) == 2
    play.do(act.SetBreakpoint(doc, (1,), is_set=True, condition="A > 1"))
    assert texts(play, doc) == set()
    play.do(act.Undo(doc))
    play.do(act.SetSynchTag(doc, 1, "meet"))
    assert texts(play, doc) == set() and not shown(play, doc).is_checked
    play.do(act.Undo(doc))
    assert len(texts(play, doc)) == 2


def test_what_was_found_for_one_robot_is_not_told_of_another(play):  # R-E09, R-X02
    play.files.module("twin", '"""Another way to do it."""\n')
    play.files.plain_task("twin", writes="A")
    doc = play.open([job("aC")])
    finds(play, 1)
    play.do(act.Preflight(doc))
    play.do(act.Redirect(doc, "", "a", "twin"))
    assert texts(play, doc) == set()


def test_a_run_that_the_runtime_refuses_marks_the_same(play):  # R-X02, R-E01
    doc = play.open([job("aC"), job("bC")])
    finds(play, 2)
    assert "cannot be reached" in str(play.answer(act.Run(doc)).no.reason)
    assert {step for step, _ in texts(play, doc)} == {2}
    finds(play)
    play.run(doc)
    assert texts(play, doc) == set() and shown(play, doc).is_checked


def test_what_is_wrong_without_a_runtime_counts_too(play):  # R-X02, R-E01
    doc = play.open([job("aC"), HOLE, job("goneC")])
    finds(play, 1)
    assert play.do(act.Preflight(doc)) == 3


def test_a_task_that_cannot_live_as_it_is_is_told_with_who_could_stand_for_it(play):  # R-X02, R-E09
    play.files.module("twin", '"""Another way to do it."""\n')
    play.files.plain_task("twin", writes="A")
    doc = play.open([job("bC"), job("aC")])
    rmod = str(play.files.path / "module" / "a.rmod")
    play.runtime.faults = (
        request.FaultText(
            rmod,
            0,
            Reason.of("host.no_such_device", world="w", devices=("arm_left",), device="arm"),
            Reason.plain("not run"),
        ),
    )
    play.do(act.Preflight(doc))
    (fault,) = shown(play, doc).faults.values()
    assert (fault.step, str(fault.text)) == (2, "there is no device arm; w has arm_left")
    assert str(fault.remedies[0].label) == "Redirect a to twin"
    play.do(fault.remedies[0].act)
    finds(play, file=str(play.files.path / "module" / "twin.rmod"))
    play.runtime.faults = (replace(request.FaultText("", 0, *FAR), file=rmod.replace("/a.rmod", "/twin.rmod")),)
    play.do(act.Preflight(doc))
    (fault,) = shown(play, doc).faults.values()
    assert fault.step == 2 and str(fault.remedies[0].label) == "Let a do it again"
    play.do(fault.remedies[0].act)
    assert shown(play, doc).redirects == ()


def test_what_is_only_worth_knowing_is_a_warning_at_its_step(play):  # R-X02
    doc = play.open([job("aC"), job("bC")])
    ask, rmod = play.runtime.ask, play.files.path / "module" / "b.rmod"
    notes = (
        Reason.of("host.note_in", file=str(rmod), note="LOCAL ODD is no parameter of module b; it is kept"),
        Reason.of("host.note_at", file=str(path(play)), line=1, note="aC ends with a"),
        Reason.plain("plain"),
    )

    def answered(wish):
        answer = ask(wish)
        return replace(answer, notes=notes) if isinstance(answer, request.Prepared) else answer

    play.runtime.ask = answered
    assert play.do(act.Preflight(doc)) == 0
    faults = {(fault.step, str(fault.text), fault.level) for fault in shown(play, doc).faults.values()}
    expected = {(2, "b: LOCAL ODD is no parameter of module b; it is kept"), (1, "aC ends with a"), (0, "plain")}
    assert faults == {(*row, "warning") for row in expected}


def test_what_runs_already_keeps_nobody_from_looking_at_another_or_at_the_same(play):  # R-X02, R-C18
    doc, other = play.open([job("aC")]), play.open([job("bC")], name="other")
    play.run(doc)
    assert play.do(act.Preflight(other)) == 0 and play.do(act.Preflight(doc)) == 0
    assert shown(play, other).is_checked
    assert len(play.carried(request.Prepare)) == 3 and len(play.carried(request.Begin)) == 1
    assert play.environment.model.run_of(doc).view.state == "running"


def test_the_plan_of_a_run_that_is_about_to_begin_is_not_exchanged(play):
    doc, other = play.open([job("aC")]), play.open([job("bC")], name="other")
    play.run(doc)
    model = play.environment.model
    play.environment.model = replaced(model, run=model.run.shown(state="beginning"))
    no = play.no(act.Preflight(other))
    assert str(no.reason) == "play is about to begin: other can be checked in a moment"
    assert len(play.carried(request.Prepare)) == 1


def test_what_has_nothing_to_run_or_a_runtime_that_refuses_is_told(play):
    blank = play.do(act.NewApplication())
    assert play.answer(act.Preflight(blank)).value == 1  # its flow is empty
    doc = play.open([job("aC")])
    play.runtime.refusals["Prepare"] = "you only watch"
    assert "cannot be checked: you only watch" in str(play.answer(act.Preflight(doc)).no.reason)
    assert not shown(play, doc).is_checked
