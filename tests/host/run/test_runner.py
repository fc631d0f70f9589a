import pytest

from kit.plan_builder import PlanBuilder, action
from kit.rail_world import YardLoading
from onika.host.loading.plan_preparation import prepare
from onika.host.run.runner import Runner
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.runtime.user_input import AskedItem
from onika.wire import event, steer
from onika.wire.request import Begin

ARM = """
from onika.module import InVar, Module, OutConst, OutVar

class Arm(Module):
    hardware = True
    N = OutConst("int", "-", "number of joints")
    Q_REF = InVar("double", "m", "where to")
    Q_MEZ = OutVar("double", "m", "where it is")
"""
GO = """
from onika.module import InConst, Module, OutVar, finish

class Go(Module):
    trigger = True
    N = InConst("int", "-", "number of joints")
    Q_REF = OutVar("double", "m", "where to")
"""
BELL = "from onika.module import Module\nclass Bell(Module):\n    trigger = True\n"
SHOW = "from onika.module import Module\nclass Show(Module):\n    passive = True\n"


class Units:
    """RTPUs that only note what they are told."""

    def __init__(self):
        self.sent = []
        self.granted = []
        self.released = []
        self.refuses = ""

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def grant(self, rtpu, device):
        if self.refuses:
            raise ValueError(self.refuses)
        self.granted.append((rtpu, device))
        return command.DeviceGrant("bus:yard", device, ("time", "drive"), ("f",), {}, 1, 0, 64)

    def release(self, device):
        self.released.append(device)

    def take(self, kind):
        found = [(rtpu, order) for rtpu, order in self.sent if isinstance(order, kind)]
        self.sent = [one for one in self.sent if one not in found]
        return found


class Bench:
    """A runner of the plan `flows`, and what came of it."""

    def __init__(self, *flows, begin=None, units=None):
        shop = PlanBuilder()
        shop.task("arm", ARM, local={"DEVICE": "yard:m0"}, rtpu="rt0")
        shop.task("go", GO, rtpu="rt1")
        shop.task("bell", BELL, rtpu="rt0")
        shop.task("show", SHOW, rtpu="rt0")
        prepared = prepare(shop.plan(*flows), (), YardLoading())
        assert prepared.faults == []
        self.tables, subsystems = {}, {}
        for number, flow in enumerate(prepared.plan.flows):
            table = self.tables[flow.subsystem] = Table(Segment.create("table", SIZE))
            rtpus = {task.name: task.rtpu for task in flow.tasks}
            subsystems[number] = RunningSubsystem(flow.subsystem, table, prepared.flows[number], rtpus)
        self.units = units or Units()
        self.told = []
        self.runner = Runner(prepared, begin or Begin(settle_s=0.5), subsystems, self.units, self.told.append)
        self.now = 1_000

    def start(self):
        self.runner.start(self.now)
        return self

    def hear(self, one, rtpu="rt0"):
        self.runner.hear(rtpu, one, self.now)
        return self

    def born(self, *names, subsystem="flow0"):
        for name in names:
            if name == "arm":
                self.tables[subsystem].ring("N").write((2).to_bytes(4, "little"))
            self.hear(news.Initialised(subsystem, name))
        return self

    def on(self, *names, subsystem="flow0"):
        for name in names:
            self.hear(news.Changed(subsystem, name, "ON", self.now))
        return self

    def finished(self, name, subsystem="flow0"):
        return self.hear(news.Finished(subsystem, name, 0, False, self.now))

    def of(self, kind):
        return [one for one in self.told if isinstance(one, kind)]


BOTH = [action("arm", "go", arguments="")]


def switches(bench):
    return [(rtpu, order.off, tuple(one.task for one in order.on)) for rtpu, order in bench.units.take(command.Switch)]


def test_tasks_are_spawned_as_soon_as_their_constants_are_there():  # law 10
    bench = Bench(BOTH).start()
    assert [(rtpu, order.task) for rtpu, order in bench.units.take(command.Spawn)] == [("rt0", "arm")]
    bench.born("arm")
    assert [(rtpu, order.task) for rtpu, order in bench.units.take(command.Spawn)] == [("rt1", "go")]
    assert bench.units.granted == [("rt0", "yard:m0")]


def test_nothing_is_switched_on_before_everything_lives():  # R-E02
    bench = Bench(BOTH).start().born("arm")
    assert switches(bench) == []
    bench.born("go")
    assert len(switches(bench)) == 1


def test_units_are_switched_one_after_the_other_so_that_the_order_of_on_holds():  # reading 14, law 2
    bench = Bench([action("arm", "go", "show")]).start().born("arm", "go", "show")
    order = []
    while found := switches(bench):
        ((rtpu, off, on),) = found
        order += [(rtpu, name) for name in on]
        assert off == ()
        bench.on(*on)
    assert {name: rtpu for rtpu, name in order} == {"arm": "rt0", "go": "rt1", "show": "rt0"}
    assert [name for _, name in order].index("arm") == 0


def test_a_group_goes_out_only_when_the_one_before_it_is_on():  # reading 14
    bench = Bench(BOTH).start().born("arm", "go")
    assert switches(bench) == [("rt0", (), ("arm",))]
    assert switches(bench) == []
    bench.on("arm")
    assert switches(bench) == [("rt1", (), ("go",))]


def test_a_task_that_fails_or_asks_at_on_holds_up_nobody():  # law 25
    bench = Bench(BOTH).start().born("arm", "go")
    switches(bench)
    bench.hear(news.Asked("flow0", "arm", "", (), bench.now))
    assert bench.runner.is_asking
    assert bench.units.take(command.Kill)  # nobody is there to answer


def test_when_the_last_trigger_has_finished_things_settle_are_read_and_reported():  # R-E03, R-E14
    bench = Bench([action("bell")], begin=Begin(watch=("X",), settle_s=0.25)).start().born("bell").on("bell")
    bench.finished("bell")
    assert bench.runner.wake_at() == bench.now + 250_000_000
    bench.runner.tick(bench.now + 249_999_999)
    assert bench.units.take(command.Report) == []
    bench.runner.tick(bench.now + 250_000_000)
    assert [rtpu for rtpu, _ in bench.units.take(command.Report)] == ["rt0"]
    assert not bench.runner.is_over
    bench.hear(news.Statuses("rt0", 0.0, ()))
    assert [order.task for _, order in bench.units.take(command.Kill)] == ["bell"]
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    assert bench.runner.is_over
    assert (bench.runner.statistics.completed, bench.runner.statistics.done) == (True, 1)


def test_the_watcher_is_told_states_actions_and_times_since_the_run_began():  # R-E11
    bench = Bench([action("bell"), action("bell")]).start().born("bell").on("bell")
    bench.now += 2_000_000_000
    bench.finished("bell")
    assert [(one.index, one.of, one.action, one.at_s) for one in bench.of(event.Began)] == [
        (0, 2, "action 0", 0.0),
        (1, 2, "action 1", 2.0),
    ]
    assert [(one.index, one.at_s) for one in bench.of(event.Done)] == [(0, 2.0)]
    assert [one.state for one in bench.of(event.TaskState)] == ["OFF", "ON", "OFF"]


def test_an_abort_kills_every_task_and_names_the_cause():  # R-E14
    bench = Bench(BOTH).start().born("arm", "go")
    bench.runner.abort("enough", bench.now)
    assert sorted(order.task for _, order in bench.units.take(command.Kill)) == ["arm", "go"]
    for name in ("arm", "go"):
        assert not bench.runner.is_over
        bench.hear(news.Changed("flow0", name, "KILLED", bench.now))
    assert bench.runner.is_over
    assert (bench.runner.statistics.completed, bench.runner.statistics.cause) == (False, "enough")
    assert bench.units.released == ["yard:m0"]


def test_an_abort_before_a_task_was_sent_kills_it_on_paper():  # law 10
    bench = Bench(BOTH).start()
    bench.runner.abort("enough", bench.now)
    assert [order.task for _, order in bench.units.take(command.Kill)] == ["arm"]
    bench.hear(news.Changed("flow0", "arm", "KILLED", bench.now))
    assert bench.runner.is_over


def test_a_second_abort_changes_nothing():
    bench = Bench([action("bell")]).start().born("bell")
    bench.runner.abort("first", bench.now)
    bench.runner.abort("second", bench.now)
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    bench.runner.abort("third", bench.now)
    assert bench.runner.statistics.cause == "first"
    assert len(bench.units.take(command.Kill)) == 1


def test_an_abort_while_things_settle_ends_the_run_as_aborted():  # R-E14
    bench = Bench([action("bell")]).start().born("bell").on("bell").finished("bell")
    bench.runner.abort("enough", bench.now)
    assert bench.runner.wake_at() is None
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    assert not bench.runner.statistics.completed


def test_a_task_in_error_ends_the_run_and_is_told_with_its_line():  # R-A09, R-E08
    bench = Bench([action("bell")]).start().born("bell").on("bell")
    bench.hear(news.Failed("flow0", "bell", "cycle", "ValueError: no", "bell.py", 7, "trace", bench.now))
    (failed,) = bench.of(event.Failed)
    assert (str(failed.text), failed.path, failed.line) == ("cycle: ValueError: no", "bell.py", 7)
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    assert bench.runner.statistics.cause == (
        "test.appl:1 (action 0): bell is in error: cycle: ValueError: no (bell.py:7)"
    )


def test_a_passive_task_in_error_is_noted_and_the_job_goes_on():  # reading 17
    bench = Bench([action("bell", "show")]).start().born("bell", "show").on("bell", "show")
    bench.hear(news.Failed("flow0", "show", "cycle", "ValueError: no", "show.py", 7, "", bench.now))
    assert bench.units.take(command.Kill) == []
    assert any("the job goes on" in one.text for one in bench.of(event.Warned))
    bench.finished("bell")
    assert bench.runner.wake_at() is not None


def test_a_device_that_cannot_be_claimed_ends_the_run_with_the_reason():  # law 16
    units = Units()
    units.refuses = "expected a device of world yard (m0), found 'm7'"
    bench = Bench(BOTH, units=units).start()
    assert bench.runner.is_over
    assert "found 'm7'" in bench.runner.statistics.cause


def test_a_lost_unit_takes_its_tasks_with_it():  # R-E10
    bench = Bench(BOTH).start().born("arm", "go")
    bench.runner.abort("processing unit rt0 is gone", bench.now)
    bench.runner.lost("rt0", "rt0 was killed", bench.now)
    assert not bench.runner.is_over
    bench.hear(news.Changed("flow0", "go", "KILLED", bench.now), "rt1")
    assert bench.runner.is_over
    assert bench.units.released == ["yard:m0"]


def test_a_lost_unit_is_not_waited_for_when_statuses_are_asked():  # R-E10
    bench = Bench([action("arm", "go")]).start().born("arm", "go").on("arm", "go").finished("go")
    bench.runner.tick(bench.now + 500_000_000)
    assert sorted(rtpu for rtpu, _ in bench.units.take(command.Report)) == ["rt0", "rt1"]
    bench.runner.abort("rt0 is gone", bench.now)
    bench.runner.lost("rt0", "rt0 was killed", bench.now)
    bench.hear(news.Changed("flow0", "go", "KILLED", bench.now), "rt1")
    assert bench.runner.is_over


def test_news_of_unknown_tasks_is_nobodys():
    bench = Bench([action("bell")]).start()
    before = list(bench.told)
    for one in (news.Initialised("flow9", "bell"), news.Finished("flow0", "nobody", 0, False, 0)):
        bench.hear(one)
    assert bench.told == before


@pytest.mark.parametrize("kind", ["ILLEGAL", "SHUTDOWN"])
def test_a_task_that_may_not_go_on_ends_the_run(kind):  # R-A08
    bench = Bench([action("bell")]).start().born("bell").on("bell")
    bench.hear(news.Signalled("flow0", "bell", kind, 0, "too hot", bench.now))
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    assert f"{kind}: too hot" in bench.runner.statistics.cause


def test_signals_that_end_nothing_change_nothing():  # R-A08
    bench = Bench([action("bell")]).start().born("bell").on("bell")
    bench.hear(news.Signalled("flow0", "bell", "LEGAL", 0, "", bench.now))
    bench.hear(news.Warned("flow0", "bell", "warm", bench.now))
    assert bench.units.take(command.Kill) == []
    assert bench.of(event.Warned)[-1].text == "warm"


# Questions

ITEM = AskedItem("level", "double", 1, "m", "how high", None, (0.0,), (1.0,))


def asking(begin):
    bench = Bench([action("bell")], begin=begin).start().born("bell")
    return bench.hear(news.Asked("flow0", "bell", "", (ITEM,), bench.now))


def answers(bench):
    return [(order.task, order.line) for _, order in bench.units.take(command.Answer)]


def test_a_given_answer_is_used_once():  # law 25
    bench = asking(Begin(answers=(("bell", "level", "0.5"),)))
    assert answers(bench) == [("bell", "0.5")]
    bench.hear(news.Asked("flow0", "bell", "too low", (ITEM,), bench.now))
    assert answers(bench) == []
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    assert bench.runner.statistics.cause.endswith(
        "task bell asks for bell.level (too low) and nobody is there to answer"
    )


def test_an_answer_under_a_name_that_is_not_asked_for_ends_the_run():  # law 25
    bench = asking(Begin(answers=(("bell", "lvl", "0.5"),)))
    assert answers(bench) == []
    bench.hear(news.Changed("flow0", "bell", "KILLED", bench.now))
    assert "task bell asks for level, and an answer is given for lvl" in bench.runner.statistics.cause


def test_whoever_is_there_is_asked_and_answers():  # law 25, R-E15
    bench = asking(Begin(may_ask=True))
    (asked,) = bench.of(event.Asked)
    assert (asked.subsystem, asked.task, asked.items[0].name, asked.items[0].high) == ("flow0", "bell", "level", (1.0,))
    assert bench.runner.is_asking
    assert bench.runner.questions("flow0") == (asked,)  # for whoever comes later
    assert bench.runner.questions("flow1") == ()
    bench.runner.answer("flow0", "bell", "0.5")
    assert answers(bench) == [("bell", "0.5")]
    bench.on("bell")
    assert bench.runner.questions("flow0") == ()
    assert not bench.runner.is_asking


def test_an_answer_to_nobody_goes_nowhere():
    bench = asking(Begin(may_ask=True))
    bench.runner.answer("flow7", "bell", "0.5")
    bench.runner.answer("flow0", "nobody", "0.5")
    assert answers(bench) == []


def test_two_flows_begin_and_end_together_on_their_own_subsystems():  # R-E04, R-E14
    bench = Bench([action("bell")], [action("show", "bell")]).start()
    assert {order.subsystem for _, order in bench.units.take(command.Spawn)} == {"flow0", "flow1"}
    bench.born("bell").born("show", "bell", subsystem="flow1")
    bench.on("bell").on("show", "bell", subsystem="flow1")
    bench.finished("bell")
    assert bench.runner.wake_at() is None
    bench.finished("bell", "flow1")
    assert bench.runner.wake_at() is not None


def test_flows_that_meet_begin_by_one_command_where_they_share_a_unit():  # R-E04
    bench = Bench([action("bell")], [action("bell")]).start()
    bench.born("bell").born("bell", subsystem="flow1")
    (together,) = [order for _, order in bench.units.take(command.Together)]
    assert [(one.subsystem, [launch.task for launch in one.on]) for one in together.switches] == [
        ("flow0", ["bell"]),
        ("flow1", ["bell"]),
    ]


def test_the_switch_that_was_prepared_is_not_sent_again():
    bench = Bench([action("bell"), action("bell", "show")]).start().born("bell", "show").on("bell")
    ((_, prepared),) = bench.units.take(command.PreparedSwitch)
    assert [one.task for one in prepared.cases[0].switch.on] == ["bell", "show"]
    bench.units.take(command.Switch)
    bench.hear(news.Finished("flow0", "bell", 0, False, bench.now, prepared.activation, 1))
    assert bench.units.take(command.Switch) == []
    assert [(one.index, one.action) for one in bench.of(event.Began)][-1][0] == 1
    late = prepared.activation  # a word about the activation before says nothing any more
    bench.hear(news.Finished("flow0", "bell", 0, False, bench.now, late, 0))
    assert len(bench.of(event.Done)) == 1


def test_a_failed_task_is_cleared_and_the_step_repeated_where_somebody_decides():  # R-E08
    bench = Bench([action("bell", "arm", "go")], begin=Begin(on_error="wait")).start()
    bench.born("arm", "bell", "go").on("bell", "arm", "go")
    bench.units.sent.clear()
    bench.hear(news.Failed("flow0", "arm", "cycle", "panic", "", 0, "", bench.now))
    assert ("bell",) in [order.off for _, order in bench.units.take(command.Switch)]  # its trigger waits for nobody
    answers = []
    bench.runner.steer(steer.Recover("flow0"), bench.now, answers.append)
    assert not answers[0]
    assert [order.task for _, order in bench.units.take(command.Clear)] == ["arm"]
    bench.hear(news.Changed("flow0", "arm", "OFF", bench.now))
    ons = [launch.task for _, order in bench.units.take(command.Switch) for launch in order.on]
    assert "arm" in ons
    assert [one.state for one in bench.of(event.Moved)] == ["stopped", "clearing", "running"]


def test_a_failure_counts_however_late_it_is_heard():  # R-E08
    bench = Bench([action("bell"), action("bell")], begin=Begin(on_error="wait")).start().born("bell").on("bell")
    ((_, prepared),) = bench.units.take(command.PreparedSwitch)
    bench.runner.steer(steer.Skip("flow0", 1), bench.now, lambda _refusal: None)
    bench.hear(news.Unprepared("flow0"))
    bench.hear(news.Failed("flow0", "bell", "off", "no", "", 0, "", bench.now, prepared.activation))
    assert [one.state for one in bench.of(event.Moved)][-1] == "stopped"
    bench.runner.steer(steer.Recover("flow0"), bench.now, lambda _refusal: None)
    assert [order.task for _, order in bench.units.take(command.Clear)] == ["bell"]
