from itertools import pairwise
from time import monotonic_ns

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.mass_world import MassWorld
from kit.worlds.rail_world import YardLoading, rail_tasks
from onika.host.loading.plan_preparation import prepare
from onika.host.run.runner import Runner
from onika.host.units.realtime_factor import RealtimeFactor
from onika.host.units.virtual import VirtualDriver
from onika.ring.segment import Segment
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.testing.fake_partner import FakePartner
from onika.wire import event
from onika.wire.request import Begin
from onika.words.reason import Reason

SECOND = 1_000_000_000


class Run:
    """One run of a plan on a driver of its own."""

    def __init__(self, shop, *flows, begin=None, rtpus=("rt0",), watch=lambda _task: None):
        self.messages = []
        self.worlds = []
        self.driver = VirtualDriver(rtpus, self.messages.append, worlds=self._open, watch=watch)
        self._begin(shop, flows, begin or Begin(watch=("X", "flow0/X", "flow1/X")), rtpus)

    def _open(self, name):
        self.worlds.append(name)
        return MassWorld()

    def _begin(self, shop, flows, begin, rtpus):
        prepared = prepare(shop.plan(*flows), (), YardLoading())
        assert prepared.faults == []
        subsystems = {}
        for number, flow in enumerate(prepared.plan.flows):
            table = Table(Segment.create("table", SIZE))
            self.driver.share(f"table:{flow.subsystem}", table.segment)
            on = {task.name: task.rtpu if task.rtpu in rtpus else "rt0" for task in flow.tasks}
            subsystems[number] = RunningSubsystem(
                flow.subsystem, table, prepared.flows[number], on, prepared.constants[number]
            )
        self.runner = Runner(prepared, begin, subsystems, self.driver, self.messages.append)
        self.driver.listen(self.runner)
        self.driver.begin()
        self.runner.start(self.driver.now)

    def to_the_end(self):
        while self.driver.advance(SECOND):
            pass
        return self

    def of(self, kind):
        return [message for message in self.messages if isinstance(message, kind)]

    @property
    def result(self):
        return self.runner.statistics.result(0, 0.0, self.driver.digest)


def move(*goals):
    return [action("mass", "servo", arguments=goal) for goal in goals]


def test_a_run_comes_to_its_end_and_the_world_to_where_it_was_told():  # R-E03, R-X08
    run = Run(rail_tasks(), move("1.0", "-2.0")).to_the_end()
    assert run.runner.is_over
    assert run.result.completed
    assert run.result.values["X"][0] == pytest.approx(-2.0, abs=1e-3)
    assert run.worlds == ["yard"]
    assert [message.index for message in run.of(event.Done)] == [0, 1]


def test_equal_runs_are_equal_bit_for_bit():  # R-X08, law 14
    first, other = (Run(rail_tasks(), move("1.0", "-2.0")).to_the_end() for _ in range(2))
    assert first.driver.digest == other.driver.digest
    assert first.messages == other.messages


def test_different_runs_are_different():  # R-X08
    digests = {Run(rail_tasks(), move(goal)).to_the_end().driver.digest for goal in ("1.0", "1.0000001", "2.0")}
    assert len(digests) == 3


def test_how_long_a_call_may_last_changes_nothing():  # law 15
    whole = Run(rail_tasks(), move("1.0")).to_the_end()
    split = Run(rail_tasks(), move("1.0"))
    calls = 1
    while split.driver.advance(0):
        calls += 1
    assert calls > 100
    assert split.driver.digest == whole.driver.digest


def test_time_moves_from_instant_to_instant_on_the_grid_of_the_tasks():  # laws 1, 2
    run = Run(rail_tasks(), move("1.0"))
    times = []
    while run.driver.advance(0):
        times.append(run.driver.now)
    assert times[:5] == [0, 2_000_000, 4_000_000, 6_000_000, 8_000_000]
    assert all(later > earlier for earlier, later in pairwise(times))


def test_the_drive_follows_from_the_first_fresh_command_and_holds_at_the_end():  # law 17
    run = Run(rail_tasks(), move("1.0")).to_the_end()
    assert run.driver.is_at_rest()
    drives = run.of(event.Drive)
    assert [(drive.device, drive.state) for drive in drives] == [("yard:m0", "DRIVEN"), ("yard:m0", "HELD")]
    assert drives[1].at_ns == run.driver.now
    assert drives[1].at_s == run.result.runtime_s  # in the time of the run that uses it


def test_two_flows_share_one_world():  # R-K02, law 18
    shop = rail_tasks()
    shop.task("other", shop.code("mass").source, frequency=500.0, local={"DEVICE": "yard:m1"}, module="mass")
    run = Run(shop, move("1.0"), [action("other", "servo", arguments="-1.0")]).to_the_end()
    assert run.worlds == ["yard"]
    assert run.result.values["flow0/X"][0] == pytest.approx(1.0, abs=1e-3)
    assert run.result.values["flow1/X"][0] == pytest.approx(-1.0, abs=1e-3)


def test_tasks_spread_over_units_keep_the_order_of_on():  # R-A15, reading 14
    run = Run(rail_tasks(rtpu="rt1"), move("1.0"), rtpus=("rt0", "rt1")).to_the_end()
    assert run.result.completed
    assert {task.task: task.rtpu for task in run.result.tasks} == {"mass": "rt0", "servo": "rt1"}
    on = [message.task for message in run.of(event.TaskState) if message.state == "ON"]
    assert on == ["mass", "servo"]


def test_time_stands_still_while_an_answer_is_awaited():  # law 15
    run = Run(rail_tasks(), [action("mass", "servo")], begin=Begin(may_ask=True))
    while run.driver.advance(SECOND):
        pass
    now = run.driver.now
    assert run.runner.is_asking
    assert run.driver.advance(SECOND) is False
    assert run.driver.now == now
    run.runner.answer("flow0", "servo", "1.0")
    assert run.to_the_end().result.completed


def test_an_abort_acts_at_the_present_time():  # R-E07
    run = Run(rail_tasks(), move("1.0"))
    for _ in range(50):
        run.driver.advance(0)
    now = run.driver.now
    run.runner.abort(Reason.plain("enough"), now)
    run.driver.advance(0)
    assert run.runner.is_over
    assert run.driver.now == now
    assert run.driver.is_at_rest()
    assert run.of(event.Drive)[-1].state == "HELD"
    assert (run.result.completed, str(run.result.cause)) == (False, "enough")
    assert run.driver.advance(SECOND) is False


def test_a_stop_holds_every_drive_for_good():  # law 27
    run = Run(rail_tasks(), move("1.0"))
    for _ in range(50):
        run.driver.advance(0)
    run.driver.stop()
    run.runner.abort(Reason.plain("stop"), run.driver.now)
    run.driver.advance(0)
    assert run.driver.is_at_rest()
    assert str(run.of(event.Drive)[-1].cause) == "stop"


def test_devices_are_free_again_after_a_run_and_the_world_stays_as_it_was():  # law 18
    run = Run(rail_tasks(), move("1.0")).to_the_end()
    where = run.result.values["X"][0]
    run._begin(rail_tasks(), [move("1.0")], Begin(watch=("X",)), ("rt0",))
    run.to_the_end()
    assert run.result.completed
    assert run.result.values["X"][0] == pytest.approx(where, abs=0.05)  # the last force pushed on while things settled
    assert run.worlds == ["yard"]
    assert run.result.runtime_s < 1.0  # it was there already


def test_whose_code_runs_is_said_before_and_after():  # law 15
    seen = []
    Run(rail_tasks(), move("1.0"), watch=seen.append).to_the_end()
    assert {"flow0/mass", "flow0/servo", ""} == set(seen)
    assert seen[-1] == ""


def test_a_task_that_fails_ends_the_run_at_once():  # R-A09
    shop = PlanBuilder()
    head = "from onika.module import Module\nclass Sick(Module):\n    trigger = True\n"
    shop.task("sick", head + "    def cycle(self):\n        1 / 0\n")
    run = Run(shop, [action("sick")]).to_the_end()
    assert run.runner.is_over
    assert "ZeroDivisionError" in str(run.result.cause)
    assert run.of(event.Failed)[0].line == 5


def test_a_world_can_be_drawn_elsewhere():
    run = Run(rail_tasks(), move("1.0"))
    assert run.driver.snapshots().keys() == {"yard"}


def test_before_a_run_nothing_happens():
    driver = VirtualDriver(("rt0",), lambda _event: None)
    assert driver.advance(SECOND) is False
    assert driver.snapshots() == {}
    assert driver.is_at_rest()


# Partners outside

ASKS = """
from onika.module import Local, Module, OutVar, Partner, finish

class Asks(Module):
    passive = PASSIVE
    N = OutVar("int", "-", "what was answered")
    PARTNER = Local("line", "-", "where it listens")
    PATIENCE = Local("double", "s", "how long it may take", default=10.0)

    def init(self):
        self.partner = Partner(self.PARTNER, patience_s=self.PATIENCE)

    def cycle(self):
        self.partner.ask("count", t=self.now)

    def sync(self):
        self.N = self.partner.answer.number("n", 0, 100)
"""

ENOUGH = """
from onika.module import InVar, Module, finish

class Enough(Module):
    trigger = True
    N = InVar("int", "-", "what was answered")

    def cycle(self):
        return finish() if self.N >= 3 or self.now >= 0.5 else None
"""


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


def outside_run(outsider, passive=False, patience="10.0", scale=None):
    shop = PlanBuilder()
    local = {"PARTNER": outsider.address, "PATIENCE": patience}
    shop.task("asks", ASKS.replace("PASSIVE", str(passive)), frequency=50.0, local=local, kind="synchronous")
    shop.task("enough", ENOUGH, frequency=100.0)
    run = Run(shop, [action("asks", "enough")], begin=Begin(watch=("N",)))
    if scale:
        run.driver._realtime_factor = RealtimeFactor(scale, 0, monotonic_ns())
    return run


def test_the_clock_stands_while_a_partner_outside_is_awaited(outsider):  # law 15, R-F04
    run = outside_run(outsider)
    assert run.driver.advance(5_000_000)
    now = run.driver.now
    for _ in range(3):
        assert run.driver.advance(5_000_000), "there is still something to do: to wait"
        assert run.driver.now == now
    call = outsider.accept()
    times = []
    while not run.runner.is_over:
        if run.driver._executive.owed():
            code = call.read()
            times.append(code["t"])
            call.answer(code, n=len(times))
        run.driver.advance(1_000_000)
    assert times[:3] == pytest.approx([0.0, 0.02, 0.04])
    assert run.result.completed
    assert run.of(event.Done)[0].at_s == pytest.approx(0.05)


def test_such_a_run_is_marked_as_one_that_may_not_repeat(outsider):  # law 15
    run = outside_run(outsider, patience="0.02")
    assert run.driver.outside == ()
    run.to_the_end()
    assert run.driver.outside == ("flow0/asks",)
    run.driver.begin()
    assert run.driver.outside == ()
    assert Run(rail_tasks(), move("1.0")).to_the_end().driver.outside == ()


@pytest.mark.parametrize("passive", [False, True])
def test_a_partner_that_never_answers_stops_the_clock_no_longer_than_its_patience(outsider, passive):  # R-F04, law 15
    run = outside_run(outsider, passive=passive, patience="0.05")
    began = monotonic_ns()
    run.to_the_end()
    assert (monotonic_ns() - began) * 1e-9 < 2.0
    assert run.result.completed is passive
    messages = run.of(event.Warned) if passive else run.of(event.Failed)
    assert "no answer within 0.05 s" in str(messages[0].text)
    assert [message.at_s for message in run.of(event.Done)] == ([pytest.approx(0.5)] if passive else [])


def test_the_clock_stands_in_scaled_time_too(outsider):  # A16, law 15
    run = outside_run(outsider, scale=1000.0)
    for _ in range(20):
        run.driver.advance(1_000_000)
    assert run.driver.now == 0
    assert run.driver.wait_s() == 0.001
    call = outsider.accept()
    while not run.runner.is_over:
        if run.driver._executive.owed():
            call.answer(call.read(), n=3)
        run.driver.advance(1_000_000)
    assert run.result.completed
