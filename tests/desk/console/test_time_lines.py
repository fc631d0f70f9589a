import pytest

from onika.wire import live, request
from onika.words.reason import Reason


def test_virtual_time_passes_in_slices_that_sum_up(sit):  # law 15
    sitting = sit()
    sitting.does("advance 1", "wait 0.5", "advance 0.01")
    assert sitting.runtime.now_s == pytest.approx(1.51, abs=1e-9)
    assert [step.seconds for step in sitting.requests_of(live.Advance)] == [0.25] * 6 + [0.01]


def test_wall_time_passes_by_itself(sit):
    sitting = sit(is_virtual=False)
    sitting.does("wait 0.5")
    assert sitting.runtime.now_s > 0.3
    assert sitting.requests_of(live.Advance) == []
    assert sitting.fails("advance 1").reason == Reason.of("console.wall_time")


@pytest.mark.parametrize("line", ["advance 0", "advance soon", "advance nan", "advance -1"])
def test_only_seconds_pass(sit, line):
    assert sit().fails(line).reason.key == "console.seconds"


@pytest.mark.parametrize("is_virtual", [True, False])
def test_a_state_is_waited_for(sit, is_virtual):  # R-A16
    def finish(runtime):
        if runtime.now_s > 0.3 and runtime.lives["main"]["jtraj"].state.value == "ON":
            runtime.ask(live.Change("main", off=("jtraj",)))

    sitting = sit(is_virtual=is_virtual, as_time_passes=finish)
    sitting.runtime.lives["main"] = {}
    sitting.does("spawn jtraj", "on jtraj", "wait jtraj OFF within 5")
    assert sitting.states() == {"jtraj": "OFF"}
    assert 0.3 < sitting.runtime.now_s < 1.0


def test_the_end_of_a_task_is_a_state_to_wait_for(sit):
    sitting = sit()
    sitting.does("spawn puma", "wait diff killed")
    assert sitting.fails("wait puma killed within 0.1").reason == Reason.of(
        "console.not_within", expected="puma KILLED", limit=0.1, reality="OFF"
    )


@pytest.mark.parametrize("is_virtual", [True, False])
def test_a_variable_is_waited_for_by_the_grammar_of_expectations(sit, is_virtual):  # law 8
    def turn(runtime):
        runtime.variables.setdefault("main", {})["Q_MEZ"] = [runtime.now_s]

    sitting = sit(is_virtual=is_virtual, as_time_passes=turn)
    sitting.does("spawn puma")
    turn(sitting.runtime)
    sitting.does("wait Q_MEZ[0] > 0.5 within 5", "wait main/Q_MEZ[0] >= 0.6")
    assert 0.6 <= sitting.runtime.now_s < 1.2


def test_what_does_not_come_is_given_up_with_what_there_is_instead(sit):
    sitting = sit()
    sitting.does("spawn puma")
    sitting.runtime.variables["main"]["LAMP"] = 0
    fault = sitting.fails("wait LAMP == 1 within 0.5")
    assert fault.reason == Reason.of("console.not_within", expected="LAMP == 1", limit=0.5, reality="0")
    assert sitting.runtime.now_s == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ("wait LAMP", "console.wait_usage"),
        ("wait __import__('os') == 1", "console.wait_usage"),
        ("wait LAMP == 1 within soon", "console.within_seconds"),
        ("wait LAMP == 1", "console.no_variable"),
        ("wait diff off", "console.not_living"),
        ("wait run", "console.no_run_to_wait_for"),
        ("wait", "console.usage"),
    ],
)
def test_a_condition_that_can_never_be_is_refused_at_once(sit, line, key):
    sitting = sit()
    sitting.does("spawn puma")
    assert sitting.fails(line).reason.key == key
    assert sitting.requests_of(live.Advance) == []


def test_no_time_passes_while_a_task_asks(asking):  # law 15
    asking.does("spawn jtraj", "on jtraj")
    assert asking.fails("advance 1").reason == Reason.of("console.tasks_ask", asking=("main/jtraj",))
    assert asking.runtime.now_s == 0.0


def test_a_clock_that_will_not_go_on_is_told(sit):
    sitting = sit()
    sitting.runtime.refusals["Advance"] = "an application runs"
    assert str(sitting.fails("wait 1").reason) == "expected the clock to go on, found an application runs"


@pytest.mark.parametrize(
    ("is_virtual", "line"), [(True, "wait 5"), (False, "wait 5"), (True, "wait X > 1"), (False, "wait X > 1")]
)
def test_ctrl_c_while_something_is_waited_for_stops_everything(sit, is_virtual, line):  # decision 11
    sitting = sit(is_virtual=is_virtual)
    sitting.does("spawn puma")
    sitting.runtime.variables["main"]["X"] = 0.0
    sitting.interrupts = 3
    assert sitting.fails(line).reason == Reason.of("console.ctrl_c")
    assert sitting.runtime.is_stopped
    assert len(sitting.requests_of(request.Stop)) == 1


def test_the_end_of_a_run_is_waited_for_no_longer_than_said(sit, monkeypatch):
    sitting = sit()
    sitting.console.carry_out("run go_home")
    monkeypatch.setattr(sitting.runtime, "events", lambda timeout_s: iter(()))
    assert str(sitting.fails("wait run within 0.2").reason) == "expected the end of go_home, found not so within 0.2 s"
