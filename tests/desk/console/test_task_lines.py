import pytest

from kit.desk.live_runtime import LiveRuntime
from kit.labs.laboratory import Laboratory
from onika.wire import live, request
from onika.words.reason import Reason

CMOVE = ("puma", "diff", "gravcomp", "pd", "torque_sum", "led_monitor", "fwdkin", "invkin", "ctraj")


def test_tasks_are_found_on_the_search_path_and_spawned_off(sit):  # R-A05, R-A14
    sitting = sit()
    output = sitting.does("spawn puma diff")
    assert sitting.states() == {"puma": "OFF", "diff": "OFF"}
    assert any("main/puma OFF" in line for line in output)
    (change,) = sitting.requests_of(live.Change)
    assert [task.place.rpartition("/")[2] for task in change.spawn] == ["puma.rmod", "diff.rmod"]
    assert {code.module for code in change.code} == {"arm", "diff"}
    assert all(code.source for code in change.code)


def test_a_spawn_may_name_unit_other_name_and_rate(sit):  # R-A06
    sitting = sit()
    sitting.does("spawn jtraj on rt1 as path at 125")
    ((name, standing),) = sitting.session.tasks().items()
    assert (name, standing.rtpu, standing.frequency, standing.task.module) == ("path", "rt1", 125.0, "jtraj")


def test_one_module_serves_two_tasks_with_one_code(sit):  # R-A01
    sitting = sit()
    sitting.does("spawn gripper gripper_right")
    (change,) = sitting.requests_of(live.Change)
    assert len(change.code) == 1


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("spawn pumma", "a task on the search path (near it: puma, puma_kin), found 'pumma'"),
        ("spawn puma on rt7", "one of the units rt0, rt1, found 'rt7'"),
        ("spawn puma at fast", "a rate in hertz after `at`, found 'fast'"),
        ("spawn puma at -1", "a rate in hertz after `at`, found '-1'"),
        ("spawn puma on", "`spawn TASK… [on RTPU] [as NAME] [at HZ]`, found `spawn puma on`"),
        ("spawn on rt1", "`spawn TASK… [on RTPU] [as NAME] [at HZ]`, found `spawn on rt1`"),
        ("spawn puma diff as x", "one task before `as`, found 2"),
        ("spawn puma other/diff", "tasks of one subsystem, as main, found other"),
        ("spawn all of", "`spawn all of CONFIGURATION`, found `spawn all of`"),
    ],
)
def test_what_cannot_be_spawned_is_told_and_nothing_is_asked(sit, line, sentence):
    sitting = sit()
    assert str(sitting.fails(line).reason) == f"expected {sentence}"
    assert sitting.requests_of(live.Change) == []


def test_a_configuration_that_is_not_there_is_not_spawned(sit):
    reason = sit().fails("spawn all of nothing").reason
    assert (reason.key, reason.args["name"]) == ("desk.not_on_search_path", "nothing")


def test_all_tasks_of_a_configuration_are_spawned_but_those_that_live(sit):  # R-A13
    sitting = sit()
    sitting.does("spawn puma", "spawn all of cmoveC")
    assert set(sitting.states()) == set(CMOVE)
    assert [task.name for task in sitting.requests_of(live.Change)[1].spawn].count("puma") == 0
    sitting.does("spawn all of cmoveC")
    assert len(sitting.requests_of(live.Change)) == 2


def test_a_task_goes_on_with_its_argument_line_as_it_was_typed(sit):  # R-A05, R-A10
    sitting = sit()
    sitting.does("spawn jtraj", 'on jtraj 0.5  "a b" 3')
    assert sitting.states() == {"jtraj": "ON"}
    assert sitting.requests_of(live.Change)[1].on == (live.Turn("jtraj", '0.5  "a b" 3'),)


def test_a_target_of_the_dictionary_gives_the_arguments(sit):
    sitting = sit()
    sitting.does("spawn jtraj", "on jtraj @home")
    assert sitting.requests_of(live.Change)[1].on == (live.Turn("jtraj", "0.0 -1.570796 1.570796 0.0 0.0 0.0 3.0"),)
    fault = sitting.fails("on jtraj @hme")
    assert str(fault.reason) == "expected a target on the search path (near it: home), found 'hme'"


def test_a_target_without_values_gives_no_arguments(sit):
    sitting = sit()
    sitting.does("spawn jtraj")
    assert sitting.fails("on jtraj @noop").reason == Reason.of("desk.target_without_values", text="@noop")


def test_all_that_is_off_goes_on_and_all_that_is_on_goes_off(sit):
    sitting = sit()
    sitting.does("spawn puma diff", "on puma", "on all")
    assert sitting.states() == {"puma": "ON", "diff": "ON"}
    sitting.does("off puma")
    assert sitting.states() == {"puma": "OFF", "diff": "ON"}
    sitting.does("off")
    assert sitting.states() == {"puma": "OFF", "diff": "OFF"}
    count = len(sitting.requests_of(live.Change))
    sitting.does("off all")
    assert len(sitting.requests_of(live.Change)) == count


def test_tasks_are_killed_one_by_one_or_with_their_subsystem(sit):  # R-A05
    sitting = sit()
    sitting.does("spawn puma diff pd", "kill diff pd")
    assert sitting.states() == {"puma": "OFF"}
    sitting.does("kill all")
    assert sitting.requests_of(live.Close) == [live.Close("main")]
    sitting.does("kill all")
    assert len(sitting.requests_of(live.Close)) == 1


def test_another_subsystem_is_named_before_the_task(sit):  # R-A06
    sitting = sit()
    sitting.does("spawn left/puma", "spawn puma", "on left/puma")
    assert (sitting.states("left"), sitting.states()) == ({"puma": "ON"}, {"puma": "OFF"})
    sitting.does("kill left/puma puma")
    assert (sitting.states("left"), sitting.states()) == ({}, {})


@pytest.mark.parametrize("line", ["on diff", "off diff", "kill puma diff", "clear diff"])
def test_a_task_that_does_not_live_is_named_with_those_that_do(sit, line):
    sitting = sit()
    sitting.does("spawn puma")
    fault = sitting.fails(line)
    assert fault.reason == Reason.of("console.not_living", subsystem="main", living=("puma",), name="diff")
    assert sitting.states() == {"puma": "OFF"}


def test_the_outcome_of_a_change_is_waited_for_and_its_cause_told(sit):
    sitting = sit()
    sitting.does("spawn puma", "on puma")
    fault = sitting.fails("on puma")
    assert str(fault.reason) == (
        "expected the change to be done, found expected one of fail, finish, kill, off, swap while ON, found on"
    )


def test_a_task_in_error_is_cleared_by_name_or_with_all_others(sit):  # R-A05
    sitting = sit()
    sitting.does("spawn puma diff pd")
    for name in ("puma", "diff"):
        sitting.runtime.lives["main"][name].state = type(sitting.runtime.lives["main"][name].state).ERROR
    sitting.session.look_again()
    sitting.does("clear puma")
    assert sitting.states() == {"puma": "OFF", "diff": "ERROR", "pd": "OFF"}
    sitting.does("clear")
    assert set(sitting.states().values()) == {"OFF"}


def test_a_configuration_replaces_what_is_there_and_leaves_what_is_in_both(sit):  # R-A13
    sitting = sit()
    sitting.does("config jmoveC @home", "config cmoveC 1 2 3")
    assert set(sitting.states()) == set(CMOVE)
    assert set(sitting.states().values()) == {"ON"}
    first, second = sitting.requests_of(live.Change)
    assert [turn.arguments for turn in first.on if turn.task == "jtraj"] == ["0.0 -1.570796 1.570796 0.0 0.0 0.0 3.0"]
    assert {task.name for task in second.spawn} == {"fwdkin", "invkin", "ctraj"}
    assert second.kill == ("jtraj",)
    assert {turn.task: turn.arguments for turn in second.on} == {"fwdkin": "", "invkin": "", "ctraj": "1 2 3"}
    assert dict(second.rates)["puma"] == 500.0


def test_arguments_that_nobody_would_take_are_refused_and_nothing_is_changed(sit, tmp_path):  # R-A13
    Laboratory(tmp_path).configuration("plain", "pd 500")
    sitting = sit()
    fault = sitting.fails("config plain 1 2 3")
    assert (fault.reason.key, fault.reason.args["name"]) == ("console.nobody_takes", "plain")
    sitting.does("config cmoveC 1 2 3")
    count = len(sitting.requests_of(live.Change))
    fault = sitting.fails("config cmoveC 4 5 6")
    assert (fault.reason.key, fault.reason.args["takers"]) == ("console.takers_are_on", ("ctraj",))
    assert len(sitting.requests_of(live.Change)) == count
    sitting.does("off ctraj", "config cmoveC 4 5 6")
    assert "4 5 6" in [turn.arguments for turn in sitting.requests_of(live.Change)[-1].on]


def test_a_switch_turns_others_off_and_keeps_them_alive(sit):  # R-C32
    sitting = sit()
    sitting.does("config jmoveC @home", "spawn all of cmoveC", "switch cmoveC 1 2 3")
    states = sitting.states()
    assert states["jtraj"] == "OFF" and {states[name] for name in CMOVE} == {"ON"}
    change = sitting.requests_of(live.Change)[-1]
    assert (change.kill, change.spawn, change.off) == ((), (), ("jtraj",))
    sitting.does("switch jmoveC @home")
    assert (sitting.states()["jtraj"], sitting.states()["ctraj"]) == ("ON", "OFF")
    assert sitting.fails("switch nothing").reason.key == "desk.not_on_search_path"


def test_a_configuration_with_a_missing_task_changes_nothing(sit, tmp_path):
    Laboratory(tmp_path).configuration("lost", "gone 9")
    sitting = sit()
    faults = sitting.console.carry_out("config lost")
    assert [(fault.reason.key, fault.reason.args["name"]) for fault in faults] == [("desk.not_on_search_path", "gone")]
    assert sitting.requests_of(live.Change) == []
    assert sitting.fails("config nothing").reason.key == "desk.not_on_search_path"


class _Starved(LiveRuntime):
    """A device's task is not cleared while a task that feeds it is in ERROR."""

    def __init__(self, **feeders):
        super().__init__()
        self.feeders = feeders

    def ask(self, wish):
        if isinstance(wish, live.Clear):
            fed = self.lives[wish.subsystem]
            writers = tuple(name for name in self.feeders.get(wish.task, ()) if fed[name].state.value == "ERROR")
            if writers:
                self.asked.append(wish)
                return request.Refused(Reason.of("host.clear_writers_first", task=wish.task, writers=writers))
        return super().ask(wish)


def _broken(sit, **feeders):
    sitting = sit(_Starved(**feeders))
    sitting.does("spawn puma diff pd")
    for life in sitting.runtime.lives["main"].values():
        life.state = type(life.state).ERROR
    sitting.session.look_again()
    return sitting


def test_several_are_cleared_whatever_waits_for_whatever(sit):  # R-A05, law 4
    sitting = _broken(sit, puma=("diff",), diff=("pd",))
    sitting.does("clear")
    assert set(sitting.states().values()) == {"OFF"}
    cleared = [wish.task for wish in sitting.requests_of(live.Clear)]
    assert cleared == ["puma", "diff", "pd", "puma", "diff", "puma"]


def test_what_is_refused_for_good_is_told_and_ends_the_clearing(sit):  # R-A05, R-X01
    sitting = _broken(sit, puma=("diff",), diff=("puma",))
    faults = sitting.console.carry_out("clear")
    assert [fault.reason.key for fault in faults] == ["console.runtime_refused"] * 2
    assert sitting.states() == {"puma": "ERROR", "diff": "ERROR", "pd": "OFF"}
    assert len(sitting.requests_of(live.Clear)) == 5
