import pytest
from msgspec.structs import replace

from onika.wire import event, request
from onika.wire.figures import TaskFigures


def test_an_application_is_begun_and_its_end_told(sit):  # R-A16
    one = sit()
    said = one.does("run go_home")
    assert "go_home: 1 action" in said
    (prepare,) = one.asked(request.Prepare)
    assert prepare.plan.application == "go_home"
    assert one.asked(request.Begin)[0].may_ask
    one.does("wait run")
    assert any("run completed, 1 of 1 actions" in line for line in one.lines)
    assert one.session.running == ""


def test_an_application_is_redirected_by_further_words(sit):  # R-E09, R-A16
    one = sit()
    one.does("run go_home 0:puma=puma_kin")
    (flow,) = one.asked(request.Prepare)[0].plan.flows
    assert [(name, old.name) for name, old in flow.replaced] == [("puma_kin", "puma")]
    one.does("wait run")
    assert one.fails("run go_home puma").expected == "[FLOW:]TASK=TASK"
    said = one.console.carry_out("run go_home puma=gripper")
    assert any("does not write" in fault.found for fault in said)


def test_home_is_the_application_go_home(sit):  # R-A16
    one = sit()
    one.does("home")
    assert one.session.running in ("go_home", "")
    assert one.asked(request.Prepare)[0].plan.application == "go_home"


def test_a_second_application_has_to_wait(sit):
    one = sit()
    one.console.carry_out("run go_home")
    assert (one.fails("run assemble").expected, one.fails("home").found) == ("no application that runs", "go_home")


def test_what_is_wrong_with_an_application_is_told_before_anything_moves(sit):
    one = sit()
    assert one.fails("run go_hone").found == "neither"
    one.runtime.faults = (request.FaultText("go_home.appl", 7, "a posture", "none", "nothing moves"),)
    assert one.fails("run go_home").place.line == 7
    one.runtime.faults = ()
    one.runtime.refusals["Begin"] = "another holds it"
    assert one.fails("run go_home").found == "another holds it"
    assert one.session.running == ""


def test_a_run_is_aborted(sit):
    one = sit()
    one.console.carry_out("run go_home")
    one.does("abort it is late")
    assert one.asked(request.Abort) == [request.Abort("it is late")]
    assert any("run aborted, 0 of 1 actions: it is late" in line for line in one.lines)
    assert one.fails("abort").expected == "an application that runs"
    assert "aborted: it is late" in one.fails("wait run").found


def test_a_question_of_an_application_goes_to_the_next_line_of_a_script(sit, monkeypatch):  # R-A10
    one = sit()
    one.session.in_script = True
    monkeypatch.setattr(one.runtime, "_command", asking_once(one.runtime))
    one.does("run go_home")
    assert one.session.running == "go_home"
    assert one.fails("wait run").found == "flow0/jtraj"
    (fault,) = one.console.finish()
    assert fault.found == "flow0/jtraj"
    one.does("answer flow0/jtraj 1", "wait run")
    assert one.session.running == ""


def asking_once(runtime):
    """An application that asks as soon as it has begun, and is over when it is answered."""
    former = runtime._command

    def command(asked):
        if isinstance(asked, request.Begin):
            runtime.tell(event.Asked("flow0", "jtraj", "", (), 0.0))
            return request.Done()
        if isinstance(asked, request.Reply):
            runtime.tell(event.Result(True, "", 1, 1, 1.0, 1.0, {}, (), ""))
            return request.Done()
        return former(asked)

    return command


def test_the_end_of_what_another_runs_is_not_the_end_of_ours(sit):
    one = sit()
    one.console.carry_out("run go_home")
    figures = TaskFigures("other", "puma", "rt0", 500.0, 1, 0, 1.0, 1.0)
    one.runtime.running = ""  # it goes on and on
    one.runtime.tell(event.Result(True, "", 9, 9, 1.0, 1.0, {}, (figures,), ""))
    one.session.hear()
    assert (one.session.running, one.session.result) == ("go_home", None)
    one.runtime.tell(event.Result(True, "", 9, 9, 1.0, 1.0, {}, (replace(figures, subsystem="flow0"),), ""))
    one.session.hear()
    assert one.session.running == ""


@pytest.mark.parametrize(("line", "name"), [("calibrate", "calibrate"), ("calibrate C", "calibrate_C")])
def test_calibration_is_an_application_of_the_laboratory(sit, tmp_path, line, name):  # R-A16
    one = sit()
    fault = one.fails(line)
    assert f"an application {name} on the search path" in fault.expected
    assert "measure absolute angles" in fault.instead
    (tmp_path / "appl").mkdir()
    shipped = one.session.site.application_file("go_home")
    (tmp_path / "appl" / f"{name}.appl").write_text(shipped.read_text())
    one.does(line)
    assert one.asked(request.Prepare)[0].plan.application == name
