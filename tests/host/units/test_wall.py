import os
import select
import signal

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.box_cells import boxes_files
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.processes.process_socket import ProcessSocket
from onika.host.run.runner import Runner
from onika.host.units.device_servers import DEVICES
from onika.host.units.supervisor import Supervisor
from onika.host.units.wall import WallDriver
from onika.ring.segment import Segment
from onika.runtime import news
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.store.shipped import shipped
from onika.wire import event
from onika.wire.request import Begin
from onika.words.reason import Reason

pytestmark = pytest.mark.site


def source(lab, module):
    return (shipped() / lab / "module" / f"{module}.py").read_text()


class Run:
    """The hand of one arm opens, in real processes; the runner lives in this one."""

    def __init__(self, rtpus=("rt0",), most="0.6"):
        self.told = []
        self.driver = WallDriver(rtpus, self.told.append, with_fifo=False)
        shop = PlanBuilder()
        shop.task("gripper", source("puma", "gripper"), frequency=250.0, local={"DEVICE": "boxes:gripper_left"})
        local = {"LEAST": most, "MOST": most}
        shop.task("opengrip", source("puma", "opengrip"), frequency=50.0, local=local)
        prepared = prepare(shop.plan([action("gripper", "opengrip")]), (), ModuleFacts())
        assert prepared.faults == []
        table = Table(Segment.create("table", SIZE))
        self.driver.share("table:flow0", table.segment)
        on = {"gripper": rtpus[0], "opengrip": rtpus[-1]}
        subsystems = {0: RunningSubsystem("flow0", table, prepared.flows[0], on)}
        self.runner = Runner(prepared, Begin(watch=("GRIP_MEZ",)), subsystems, self.driver, self.told.append)
        self.driver.offer((boxes_files(),))
        self.driver.listen(self.runner)
        self.driver.begin()
        self.runner.start(self.driver.now)

    def until(self, is_there):
        while not is_there():
            select.select([post.post for post in self.driver.posts()], [], [], self.driver.wait_s())
            self.driver.advance(0)

    def driven(self):
        self.until(lambda: any(isinstance(message, event.Drive) and message.state == "DRIVEN" for message in self.told))

    def over(self):
        self.until(lambda: self.runner.is_over)
        self.until(self.driver.is_at_rest)
        return self.runner.statistics

    @property
    def drives(self):
        return [message.state for message in self.told if isinstance(message, event.Drive)]


@pytest.fixture
def start():
    runs = []
    yield lambda **settings: runs.append(Run(**settings)) or runs[-1]
    for run in runs:
        processes = list(run.driver._supervisor.processes.values())
        run.driver.close()
        assert all(process.process.returncode is not None for process in processes)


def test_a_run_in_real_processes_comes_to_its_end(start):  # R-A15, R-E03, laws 16, 30
    run = start(rtpus=("left", "right"), most="0.3")
    statistics = run.over()
    assert (statistics.completed, statistics.done) == (True, 1)
    assert statistics.values["GRIP_MEZ"][0] > 0.1  # m: the hand is open
    assert run.drives == ["DRIVEN", "HELD"]
    assert run.driver.granted.keys() == {"left", "right", DEVICES}
    assert run.driver.snapshots().keys() == {"boxes"}
    assert run.driver.digest == ""


def test_a_stop_goes_straight_to_the_drives(start):  # law 27
    run = start(most="60")
    run.driven()
    run.driver.stop()
    run.runner.abort(Reason.plain("stop"), run.driver.now)
    statistics = run.over()
    assert (statistics.completed, str(statistics.cause)) == (False, "stop")
    assert run.drives == ["DRIVEN", "HELD"]
    assert [str(message.cause) for message in run.told if isinstance(message, event.Drive)][-1] == "stop"


def test_a_lost_unit_is_fenced_and_ends_the_run(start):  # R-E10, law 17
    run = start(most="60")
    run.driven()
    os.kill(run.driver._supervisor.processes["rt0"].process.pid, signal.SIGKILL)
    # where the blow meets a task in its call, the cause names that task as well
    assert str(run.over().cause).startswith("processing unit rt0 was killed by signal 9")
    assert run.drives == ["DRIVEN", "TRIPPED"]
    assert run.driver.posts() == [run.driver._supervisor.processes[DEVICES]]


def test_a_lost_device_server_ends_the_run_and_leaves_nothing_to_draw(start):  # R-E10, law 17
    run = start(most="60")
    run.driven()
    os.kill(run.driver._supervisor.processes[DEVICES].process.pid, signal.SIGKILL)
    assert str(run.over().cause) == "the device server was killed by signal 9"
    assert any(isinstance(message, event.Failed) and message.task == "gripper" for message in run.told)
    assert run.driver.snapshots() == {}
    with pytest.raises(ValueError, match="gone"):
        run.driver.grant("rt0", "boxes:lamp")


def test_who_complains_first_of_a_silent_device_does_not_hide_that_its_server_was_killed(start):  # R-E10
    run = start(most="60")
    run.driven()
    os.kill(run.driver._supervisor.processes[DEVICES].process.pid, signal.SIGKILL)
    while not any(isinstance(heard, news.Failed) for _, heard in run.driver._heard):
        select.select([run.driver._supervisor.processes["rt0"].post], [], [])
        run.driver._receive()
    assert str(run.over().cause) == "the device server was killed by signal 9"


def test_a_copy_of_a_world_has_a_server_of_its_own_and_all_drives_hold_when_it_is_lost(start):  # R-E09, R-E10
    run = start(most="60")
    run.driven()
    run.driver.expect(["boxes@copy"])
    run.driver.grant("rt0", "boxes@copy:gripper_left")
    assert run.driver.snapshots().keys() == {"boxes", "boxes@copy"}
    os.kill(run.driver._supervisor.processes[f"{DEVICES} of boxes@copy"].process.pid, signal.SIGKILL)
    run.until(lambda: run.runner.is_over and run.drives[-1] == "HELD")
    assert run.driver.snapshots() == {}


def test_a_device_server_that_lives_but_does_not_answer_is_not_waited_for_long(start, monkeypatch):  # R-E10
    run = start(most="60")
    run.driven()
    monkeypatch.setattr(ProcessSocket, "send", lambda *_: None)
    with pytest.raises(ValueError, match="waited 2 s"):
        run.driver.touch("boxes", "panic_left", 1.0)
    monkeypatch.undo()


def test_a_device_that_is_not_there_is_refused_with_the_reason(start):  # law 16
    run = start(most="60")
    for device, reason in (("sea:m0", "'sea'"), ("boxes:tail", "'tail'"), ("boxes", "WORLD:DEVICE")):
        with pytest.raises(ValueError, match=reason):
            run.driver.grant("rt0", device)


def test_a_unit_that_cannot_start_is_the_end_of_all(monkeypatch):  # R-E10
    kept = []

    def start_and_kill(supervisor, *arguments, **settings):
        kept.append(launch(supervisor, *arguments, **settings))
        kept[-1].process.kill()
        return kept[-1]

    launch = Supervisor.launch
    monkeypatch.setattr(Supervisor, "launch", start_and_kill)
    with pytest.raises(ValueError, match="was killed by signal 9, while waiting for the processes to start"):
        WallDriver(("rt0",), lambda _: None, with_fifo=False)
    assert len(kept) == 2
    assert all(supervised.process.returncode is not None for supervised in kept)


def test_a_world_is_put_back_by_the_process_that_steps_it(start):  # law 18
    run = start()
    run.over()
    assert run.driver.displaced() == {"boxes": ()}
    run.driver.put_back("boxes")
    assert run.driver.displaced() == {"boxes": ()}
    with pytest.raises(ValueError, match="'sea'"):
        run.driver.put_back("sea")
    os.kill(run.driver._supervisor.processes[DEVICES].process.pid, signal.SIGKILL)
    run.until(lambda: run.driver._devices.is_lost)
    assert run.driver.displaced() == {}


def fails(*_args):
    raise ValueError(Reason.plain("a unit was lost meanwhile"))


def test_a_device_whose_claim_was_given_up_is_nobodys_and_can_be_claimed_again(monkeypatch):  # R-X24, law 18
    driver = WallDriver(("rt0",), lambda _: None, with_fifo=False)
    driver.offer((boxes_files(),))
    try:
        driver.grant("rt0", "boxes:arm_left")  # its world is open from now on
        with monkeypatch.context() as broken:
            broken.setattr(driver._worlds, "_wait", fails)
            with pytest.raises(ValueError, match="a unit was lost meanwhile"):
                driver.grant("rt0", "boxes:gripper_left")
        assert driver.grant("rt0", "boxes:gripper_left").name == "gripper_left"
        assert driver.views.scene("boxes") is not None
    finally:
        driver.close()


def test_a_look_at_a_world_that_is_broken_off_shows_nothing_and_ends_nothing(monkeypatch):  # R-X24
    driver = WallDriver(("rt0",), lambda _: None, with_fifo=False)
    driver.offer((boxes_files(),))
    try:
        driver.grant("rt0", "boxes:arm_left")
        with monkeypatch.context() as broken:
            broken.setattr(driver._worlds, "_wait", fails)
            assert driver.views.scene("boxes") is None
        assert driver.views.scene("boxes") is not None
    finally:
        driver.close()
