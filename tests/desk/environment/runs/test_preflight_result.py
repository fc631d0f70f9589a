import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job, target
from onika.desk.environment.runs.preflight_result import worth_noting
from onika.desk.environment.runs.readiness import ReadinessCase, ReadinessJudge, judged
from onika.desk.environment.state.open_application import PreflightResult
from onika.wire import act, request
from onika.wire.view import ShowValues
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def result_of(play, doc):
    opened = play.environment.model.applications[doc]
    return opened.looked_at(play.environment.model.runtime.address)


def test_what_was_found_is_of_the_content_the_redirections_and_the_runtime_of_then(play):  # R-X02
    doc = play.open([job("aC")])
    assert result_of(play, doc) is None
    play.do(act.Preflight(doc))
    assert isinstance(result_of(play, doc), PreflightResult)
    opened = play.environment.model.applications[doc]
    assert opened.looked_at("ws://elsewhere") is None


def test_what_was_found_in_files_that_have_changed_is_forgotten(play, tmp_path):  # R-X02
    doc = play.open([job("aC")])
    play.runtime.faults = (
        request.FaultText(
            str(tmp_path / "module" / "a.rmod"),
            0,
            Reason.plain("expected a device, found DEVICE arm"),
            Reason.plain("x"),
        ),
    )
    play.do(act.Preflight(doc))
    model, judge = play.environment.model, ReadinessJudge(play.site)
    before = ReadinessCase(model.applications[doc], model.syntax, ())
    play.environment.become(lambda model: judged(model, doc, judge.judge(before)))
    assert result_of(play, doc) is not None
    (tmp_path / "module" / "a.rmod").write_text((tmp_path / "module" / "a.rmod").read_text() + "# mended\n")
    (case,) = judge.stale(play.environment.model)
    play.environment.become(lambda model: judged(model, doc, judge.judge(case)))
    assert result_of(play, doc) is None


def test_a_target_is_named_by_its_icon_and_marked_there(play, tmp_path):  # R-X02
    doc = play.open([job("aC", "Joint job"), target("home", "Joint object", "0 0", "1.0"), job("bC")])
    file = str(tmp_path / "appl" / "play.appl")
    far = request.FaultText(
        file,
        1,
        Reason.of("host.unreachable", target="home", why="joint 3 at 9.00 rad is beyond 3.93"),
        Reason.plain("x"),
    )
    play.runtime.faults = (far,)
    play.do(act.Preflight(doc))
    fault = next(fault for fault in play.environment.tree.applications[doc].faults.values() if fault.is_of_runtime)
    assert (fault.step, str(fault.text)) == (2, "“a target” cannot be reached: joint 3 at 9.00 rad is beyond 3.93")
    assert fault.remedies[0].show == ShowValues(2)


def test_a_run_counts_the_targets_that_are_re_resolved_and_names_no_joint_values(play):  # R-E09
    def resolved(name, task="scara", at=0):
        return request.Resolved(0, at, name, task, "puma", (0.1, 0.2), (0.3,))

    near = Reason.of("host.resolved_often", target="near", task="scara", count=2, old="puma", numbers="0.3")
    notes = (Reason.of("host.note_at", file="play.appl", line=4, note=near), Reason.plain("other"))
    twice = request.Prepared((), notes, resolved=(resolved("near"), resolved("near", at=1), resolved("far")))
    assert list(map(str, worth_noting(twice))) == [
        "other",
        "2 targets are re-resolved for scara, by the poses that they are for puma",
    ]
    once = request.Prepared((), (), resolved=(resolved("near"),))
    assert list(map(str, worth_noting(once))) == ["1 target is re-resolved for scara, by the pose that it is for puma"]
