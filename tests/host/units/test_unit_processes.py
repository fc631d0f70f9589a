import pytest

from kit.process.noted_process import NotedSupervisor
from onika.host.units import rtpu
from onika.host.units.unit_processes import START_NS, UnitProcesses
from onika.ring.segment import Segment, SharedMemoryRefused
from onika.runtime import command
from onika.words.reason import NOTHING, Reason

WHY = Reason.plain("it ended")


@pytest.fixture
def supervisor():
    return NotedSupervisor(rtpu.__name__, rtpu.decode_command)


@pytest.fixture
def units(supervisor):
    units = UnitProcesses(supervisor, ["rt1", "rt0"])
    assert supervisor.launched == {name: ("--name", name, True) for name in ("rt0", "rt1")}
    for process in supervisor.processes.values():
        process.is_up = True
    return units


@pytest.fixture
def answers():
    return []


@pytest.fixture
def table():
    segment = Segment.create("test", 4096)
    yield segment
    segment.close()


def test_a_unit_that_is_added_sees_what_all_see_and_its_start_is_answered(units, supervisor, answers, table):  # law 30
    units.share("table:gone", table)
    units.share("bus:boxes", table)
    units.unshare("table:gone")
    units.add("rt2", 0, answers.append)
    added = supervisor.processes["rt2"]
    units.answer_starts(1)
    assert (answers, units.starting) == ([], ("rt2",))
    added.is_up = True
    units.answer_starts(2)
    assert (answers, units.starting) == ([NOTHING], ())
    assert added.orders == [(rtpu.Share("bus:boxes"), table.fd)]
    units.send("rt2", command.Load())
    units.share("table:main", table)
    assert added.orders[1:] == [(command.Load(),), (rtpu.Share("table:main"), table.fd)]


def test_a_unit_that_is_added_after_a_stop_is_stopped_until_motion_is_allowed(units, supervisor, answers):  # law 27
    units.stop()
    units.add("rt2", 0, answers.append)
    assert supervisor.processes["rt2"].orders == [(command.Stop(),)]
    units.reset()
    assert supervisor.processes["rt2"].orders == [(command.Stop(),), (command.Reset(),)]
    units.add("rt3", 0, answers.append)
    assert supervisor.processes["rt3"].orders == []


def test_a_stop_reaches_every_unit_that_lives(units, supervisor):  # law 27
    supervisor.processes["rt0"].is_lost = True
    units.add("rt2", 0, lambda _: None)
    units.stop()
    assert [supervisor.processes[name].orders for name in ("rt1", "rt2")] == [[(command.Stop(),)]] * 2
    assert supervisor.processes["rt0"].orders == []


def test_a_lost_unit_is_told_nothing_until_another_process_stands_in_its_place(units, supervisor, answers):  # law 30
    first = supervisor.processes["rt0"]
    first.is_lost = True
    units.send_all(command.Stop())
    assert first.orders == []
    units.add("rt0", 0, answers.append)
    second = supervisor.processes["rt0"]
    units.send_all(command.Load())
    assert (first.orders, second.orders) == ([], [(command.Load(),)])
    assert supervisor.processes["rt1"].orders == [(command.Stop(),), (command.Load(),)]


def test_a_unit_that_ends_while_it_starts_is_no_loss_but_an_answer(units, supervisor, answers):  # R-E10
    units.add("rt2", 0, answers.append)
    assert units.fail_start(supervisor.processes["rt2"], WHY)
    name = Reason.of("host.processing_unit", name="rt2")
    assert answers == [Reason.of("host.unit_not_started", name=name, why=WHY)]
    assert not units.fail_start(supervisor.processes["rt0"], WHY)
    assert len(answers) == 1


def test_a_unit_that_never_comes_up_is_ended(units, supervisor, answers):  # R-E10
    units.add("rt2", 5, answers.append)
    units.answer_starts(START_NS + 4)
    assert answers == []
    units.answer_starts(START_NS + 5)
    added = supervisor.processes["rt2"]
    assert added.is_ended and added.is_lost
    assert [answer.key for answer in answers] == ["host.unit_not_started"]
    assert units.starting == ()


def test_a_system_that_has_nothing_left_for_a_unit_says_so(units, supervisor, answers):  # law 31
    former = supervisor.processes["rt0"]
    supervisor.refusal = SharedMemoryRefused(WHY)
    units.add("rt0", 0, answers.append)
    assert (answers, units.starting) == ([WHY], ())
    units.send("rt0", command.Load())
    assert former.orders == [(command.Load(),)]
