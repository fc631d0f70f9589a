import pytest

from onika.wire import live, request


def test_virtual_time_passes_in_slices_that_sum_up(sit):  # law 15
    one = sit()
    one.does("advance 1", "wait 0.5", "advance 0.01")
    assert one.runtime.now_s == pytest.approx(1.51, abs=1e-9)
    assert [step.seconds for step in one.asked(live.Advance)] == [0.25] * 6 + [0.01]


def test_wall_time_passes_by_itself(sit):
    one = sit(is_virtual=False)
    one.does("wait 0.5")
    assert one.runtime.now_s > 0.3
    assert one.asked(live.Advance) == []
    assert "one in wall time" in one.fails("advance 1").found


@pytest.mark.parametrize("line", ["advance 0", "advance soon", "advance nan", "advance -1"])
def test_only_seconds_pass(sit, line):
    assert sit().fails(line).expected == "seconds above 0"


@pytest.mark.parametrize("is_virtual", [True, False])
def test_a_state_is_waited_for(sit, is_virtual):  # R-A16
    def finish(runtime):
        if runtime.now_s > 0.3 and runtime.lives["main"]["jtraj"].state.value == "ON":
            runtime.ask(live.Change("main", off=("jtraj",)))

    one = sit(is_virtual=is_virtual, as_time_passes=finish)
    one.runtime.lives["main"] = {}
    one.does("spawn jtraj", "on jtraj", "wait jtraj OFF within 5")
    assert one.states() == {"jtraj": "OFF"}
    assert 0.3 < one.runtime.now_s < 1.0


def test_the_end_of_a_task_is_a_state_to_wait_for(sit):
    one = sit()
    one.does("spawn puma", "wait diff killed")
    assert one.fails("wait puma killed within 0.1").found == "OFF"


@pytest.mark.parametrize("is_virtual", [True, False])
def test_a_variable_is_waited_for_by_the_grammar_of_expectations(sit, is_virtual):  # law 8
    def turn(runtime):
        runtime.variables.setdefault("main", {})["Q_MEZ"] = [runtime.now_s]

    one = sit(is_virtual=is_virtual, as_time_passes=turn)
    one.does("spawn puma")
    turn(one.runtime)
    one.does("wait Q_MEZ[0] > 0.5 within 5", "wait main/Q_MEZ[0] >= 0.6")
    assert 0.6 <= one.runtime.now_s < 1.2


def test_what_does_not_come_is_given_up_with_what_there_is_instead(sit):
    one = sit()
    one.does("spawn puma")
    one.runtime.variables["main"]["LAMP"] = 0
    fault = one.fails("wait LAMP == 1 within 0.5")
    assert (fault.expected, fault.found) == ("LAMP == 1 within 0.5 s", "0")
    assert one.runtime.now_s == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("wait LAMP", "seconds, `run`, `TASK STATE`, `FLOW STATE` or a comparison"),
        ("wait __import__('os') == 1", "seconds, `run`, `TASK STATE`, `FLOW STATE` or a comparison"),
        ("wait LAMP == 1 within soon", "seconds after `within`"),
        ("wait LAMP == 1", "a variable of main"),
        ("wait diff off", "a living task of main (puma)"),
        ("wait run", "a run to wait for"),
        ("wait", "`wait SECONDS  |  wait CONDITION [within SECONDS]`"),
    ],
)
def test_a_condition_that_can_never_be_is_refused_at_once(sit, line, expected):
    one = sit()
    one.does("spawn puma")
    assert expected in one.fails(line).expected
    assert one.asked(live.Advance) == []


def test_no_time_passes_while_a_task_asks(asking):  # law 15
    asking.does("spawn jtraj", "on jtraj")
    assert asking.fails("advance 1").found == "main/jtraj"
    assert asking.runtime.now_s == 0.0


def test_a_clock_that_will_not_go_on_is_told(sit):
    one = sit()
    one.runtime.refusals["Advance"] = "an application runs"
    assert one.fails("wait 1").found == "an application runs"


@pytest.mark.parametrize(
    ("is_virtual", "line"), [(True, "wait 5"), (False, "wait 5"), (True, "wait X > 1"), (False, "wait X > 1")]
)
def test_ctrl_c_while_something_is_waited_for_stops_everything(sit, is_virtual, line):  # decision 11
    one = sit(is_virtual=is_virtual)
    one.does("spawn puma")
    one.runtime.variables["main"]["X"] = 0.0
    one.interrupts = 3
    assert one.fails(line).found == "one"
    assert one.runtime.is_stopped
    assert len(one.asked(request.Stop)) == 1


def test_the_end_of_a_run_is_waited_for_no_longer_than_said(sit, monkeypatch):
    one = sit()
    one.console.carry_out("run go_home")
    monkeypatch.setattr(one.runtime, "events", lambda timeout_s: iter(()))
    assert one.fails("wait run within 0.2").found == "not so within 0.2 s"
