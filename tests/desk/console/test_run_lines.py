from msgspec.structs import replace

from onika.engine.program import FlowProgram
from onika.wire import event, request
from onika.wire.figures import TaskFigures
from onika.wire.plan import Jump
from onika.words.reason import NOTHING, Reason


def test_an_application_is_begun_and_its_end_told(sit):  # R-A16
    sitting = sit()
    output = sitting.does("run go_home")
    assert "go_home: 1 action" in output
    (prepare,) = sitting.requests_of(request.Prepare)
    assert prepare.plan.application == "go_home"
    assert sitting.requests_of(request.Begin)[0].may_ask
    sitting.does("wait run")
    assert any("run completed, 1 of 1 actions" in line for line in sitting.lines)
    assert sitting.session.running == ""


def test_an_application_is_redirected_by_further_words(sit):  # R-E09, R-A16
    sitting = sit()
    sitting.does("run go_home 0:puma=puma_kin")
    (flow,) = sitting.requests_of(request.Prepare)[0].plan.flows
    assert [(name, old.name) for name, old in flow.replaced] == [("puma_kin", "puma")]
    sitting.does("wait run")
    assert (
        str(sitting.fails("run go_home puma").reason)
        == "expected [FLOW:]TASK=TASK or [FLOW:]WORLD:=WORLD:, found 'puma'"
    )
    output = sitting.console.carry_out("run go_home puma=gripper")
    assert any("does not write" in str(fault.reason) for fault in output)


def test_a_flow_begins_at_an_action_where_a_word_says_so(sit):  # R-K06, R-A16
    sitting = sit()
    sitting.does("begin assemble puma=puma_kin @5")
    (flow,) = sitting.requests_of(request.Prepare)[0].plan.flows
    assert flow.program[0] == Jump(FlowProgram(flow).entries[4])
    assert [name for name, _ in flow.replaced] == ["puma_kin"]
    sitting.does("abort")
    assert sitting.fails("begin assemble flow7@5").reason.key == "console.begins_at"
    assert sitting.fails("begin assemble flow0@99").reason.key == "desk.action_range"


def test_home_is_the_application_go_home(sit):  # R-A16
    sitting = sit()
    sitting.does("home")
    assert sitting.session.running in ("go_home", "")
    assert sitting.requests_of(request.Prepare)[0].plan.application == "go_home"


def test_a_second_application_has_to_wait(sit):
    sitting = sit()
    sitting.console.carry_out("run go_home")
    for line in ("run assemble", "home"):
        assert sitting.fails(line).reason == Reason.of("console.one_runs_already", name="go_home")


def test_what_is_wrong_with_an_application_is_told_before_anything_moves(sit):
    sitting = sit()
    assert sitting.fails("run go_hone").reason.key == "desk.application_unknown"
    sitting.runtime.faults = (
        request.FaultText(
            "go_home.appl", 7, Reason.plain("expected a posture, found none"), Reason.plain("nothing moves")
        ),
    )
    assert sitting.fails("run go_home").place.line == 7
    sitting.runtime.faults = ()
    sitting.runtime.refusals["Begin"] = "another holds it"
    assert str(sitting.fails("run go_home").reason) == "expected the runtime to do it, found another holds it"
    assert sitting.session.running == ""


def test_a_run_is_aborted(sit):
    sitting = sit()
    sitting.console.carry_out("run go_home")
    sitting.does("abort it is late")
    assert sitting.requests_of(request.Abort) == [request.Abort(Reason.plain("it is late"))]
    assert any("run aborted, 0 of 1 actions: it is late" in line for line in sitting.lines)
    assert sitting.fails("abort").reason == Reason.of("console.no_application_runs")
    assert str(sitting.fails("wait run").reason) == "expected the run completed, found it was aborted: it is late"


def test_a_question_of_an_application_goes_to_the_next_line_of_a_script(sit, monkeypatch):  # R-A10
    sitting = sit()
    sitting.session.in_script = True
    monkeypatch.setattr(sitting.runtime, "_command", asking_once(sitting.runtime))
    sitting.does("run go_home")
    assert sitting.session.running == "go_home"
    assert sitting.fails("wait run").reason == Reason.of("console.tasks_ask", asking=("flow0/jtraj",))
    (fault,) = sitting.console.finish()
    assert fault.reason == Reason.of("console.tasks_ask", asking=("flow0/jtraj",))
    sitting.does("answer flow0/jtraj 1", "wait run")
    assert sitting.session.running == ""


def asking_once(runtime):
    """An application that asks as soon as it has begun, and is over when it is answered."""
    former = runtime._command

    def command(message):
        if isinstance(message, request.Begin):
            runtime.tell(event.Asked("flow0", "jtraj", NOTHING, (), 0.0))
            return request.Done()
        if isinstance(message, request.Reply):
            runtime.tell(event.Result(True, NOTHING, 1, 1, 1.0, 1.0, {}, (), ""))
            return request.Done()
        return former(message)

    return command


def test_the_end_of_what_another_runs_is_not_the_end_of_ours(sit):
    sitting = sit()
    sitting.console.carry_out("run go_home")
    figures = TaskFigures("other", "puma", "rt0", 500.0, 1, 0, 1.0, 1.0)
    sitting.runtime.running = ""  # it goes on and on
    sitting.runtime.tell(event.Result(True, NOTHING, 9, 9, 1.0, 1.0, {}, (figures,), ""))
    sitting.session.hear()
    assert (sitting.session.running, sitting.session.result) == ("go_home", None)
    sitting.runtime.tell(event.Result(True, NOTHING, 9, 9, 1.0, 1.0, {}, (replace(figures, subsystem="flow0"),), ""))
    sitting.session.hear()
    assert sitting.session.running == ""


def test_calibration_is_an_application_of_the_laboratory(sit, tmp_path):  # R-A16
    sitting = sit()
    assert sitting.fails("calibrate C").reason == Reason.of("console.no_calibration", name="calibrate_C")
    (tmp_path / "appl").mkdir()
    shipped = sitting.session.site.application_file("go_home")
    (tmp_path / "appl" / "calibrate_C.appl").write_text(shipped.read_text())
    sitting.does("calibrate C")
    assert sitting.requests_of(request.Prepare)[0].plan.application == "calibrate_C"
    assert sitting.requests_of(request.Begin)[0].watch == ()  # nobody in it writes Q_OFF


def test_the_shipped_calibration_tells_at_its_end_how_far_joints_are_off(sit):  # R-A16
    sitting = sit()
    sitting.does("calibrate")
    assert sitting.requests_of(request.Prepare)[0].plan.application == "calibrate"
    assert sitting.requests_of(request.Begin)[0].watch == ("flow0/Q_OFF",)
    values = {"flow0/Q_OFF": [0.001, -0.002]}
    sitting.runtime.tell(event.Result(True, NOTHING, 3, 3, 9.0, 9.0, values, (), ""))
    start = len(sitting.lines)
    sitting.session.hear()
    assert any("flow0/Q_OFF" in line and "-0.002" in line for line in sitting.lines[start:])
