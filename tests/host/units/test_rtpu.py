import os
import select
import threading
from collections import deque
from time import monotonic_ns

import pytest

from onika.host.processes.process_socket import ProcessSocket
from onika.host.units import rtpu as room
from onika.host.units.heartbeat import SIZE, Heartbeat
from onika.host.units.rtpu import Rtpu, Share, UnitReady
from onika.ring.segment import Segment
from onika.runtime import command, news, table as tables
from onika.words.shape import Shape

COUNT = """
from onika.module import Module, OutVar, finish

class Count(Module):
    trigger = True
    N = OutVar("int", "-", "cycles")

    def init(self):
        self._count = 0

    def cycle(self):
        self._count += 1
        self.N = self._count
        return finish() if self._count == 5 else None
"""


class Unit:
    """A processing unit in a thread, and the runner's end of its post."""

    def __init__(self, *, keeps_grid=False):
        self.post, theirs = ProcessSocket.pair()
        self._theirs = ProcessSocket(theirs)
        self._heard = deque()
        beat = Segment.create("beat", SIZE)
        self.heartbeat = Heartbeat(beat)
        self.table = tables.Table(Segment.create("table", tables.SIZE))
        rtpu = Rtpu("rt0", self._theirs, Heartbeat(Segment.attach(os.dup(beat.fd))), monotonic_ns())
        if keeps_grid:
            rtpu.keep_the_grid()
        self.thread = threading.Thread(target=rtpu.run)
        self.thread.start()
        self.post.send(room.encode(Share("table:flow0")), (self.table.segment.fd,))

    def say(self, order):
        self.post.send(room.encode(order))

    def batches(self, number):
        """The next datagrams, each a list of news."""
        batches = []
        while len(batches) < number:
            received = self.post.receive()
            if received is not None:
                batches.append(room.decode_news(received[0]))
            else:
                assert select.select([self.post], [], [], 20.0)[0]
        return batches

    def hear(self, kind):
        """The next news of a kind."""
        while True:
            while self._heard:
                report = self._heard.popleft()
                if isinstance(report, kind):
                    return report
            received = self.post.receive()
            if received is not None:
                self._heard += room.decode_news(received[0])
            else:
                assert select.select([self.post], [], [], 20.0)[0], f"no {kind.__name__}"

    def spawn(self, source=COUNT, task="count"):
        entry = self.table.entry("N", Shape.parse("int"))
        ports = (command.BoundPort("N", "N", "int", entry.offset),)
        self.say(command.Spawn("flow0", task, "count", "count.py", source, "periodic", 200.0, (), ports, 0, 0, None))

    def close(self):
        self.post.close()
        self.thread.join(20.0)
        assert not self.thread.is_alive()
        self._theirs.close()


@pytest.fixture
def unit():
    unit = Unit()
    yield unit
    unit.close()


@pytest.fixture(params=[False, True], ids=["shares a processor", "is woken early"])
def either_unit(request):
    unit = Unit(keeps_grid=request.param)
    yield unit
    unit.close()


def test_a_task_is_spawned_cycles_into_the_shared_table_and_finishes(either_unit):  # law 2
    either_unit.spawn()
    assert either_unit.hear(news.Initialised).task == "count"
    either_unit.say(command.Switch("flow0", (), (), (command.Launch("count"),)))
    assert either_unit.hear(news.Changed).state == "ON"
    first = either_unit.hear(news.Cycled).at_ns
    finished = either_unit.hear(news.Finished)
    # Five cycles of 4 ms, each at its release or later; the first may be late, but by less than a period.
    assert finished.now_ns - first > 3 * 4_000_000
    assert either_unit.table.value("N") == 5


def test_what_is_said_between_two_cycles_is_heard(either_unit):  # law 27
    either_unit.spawn(COUNT.replace("== 5", "== 0"))
    either_unit.hear(news.Initialised)
    either_unit.say(command.Switch("flow0", (), (), (command.Launch("count"),)))
    either_unit.hear(news.Cycled)
    either_unit.say(command.Stop())
    assert either_unit.hear(news.Changed).state == "OFF"


class Clock:
    """Time that passes while somebody sleeps, and a little with each look at it."""

    def __init__(self, wakes_ns):
        self.now_ns, self.looks = 0, 0
        self._wakes_ns = iter(wakes_ns)

    def monotonic_ns(self):
        self.looks += 1
        assert self.looks < 1000, "expected somebody who sleeps, found one who waits awake"
        self.now_ns += 1000
        return self.now_ns

    def select(self, _readers, _writers, _others, wait_s):
        """Asleep, and up again so much later than wished."""
        self.now_ns += round(wait_s * 1e9) + next(self._wakes_ns)
        return [], [], []


@pytest.fixture
def slept(monkeypatch):
    """A loop that keeps the grid, by a clock that is handed in."""

    def make(wakes_ns):
        clock = Clock(wakes_ns)
        monkeypatch.setattr(room, "monotonic_ns", clock.monotonic_ns)
        monkeypatch.setattr(room.select, "select", clock.select)
        mine, theirs = ProcessSocket.pair()
        posts.extend((mine, ProcessSocket(theirs)))
        rtpu = Rtpu("rt0", posts[-1], Heartbeat(Segment.create("beat", SIZE)), 0)
        rtpu.keep_the_grid()
        return rtpu, clock

    posts = []
    yield make
    for post in posts:
        post.close()


def test_whoever_is_woken_before_the_instant_waits_for_it_and_not_longer(slept):
    rtpu, clock = slept([50_000] * 400)
    for number in range(1, 401):
        due = number * 2_000_000
        assert rtpu._sleep_until(due) is False
        clock.looks = 0
    assert due <= clock.now_ns < due + 2000


def test_an_event_that_comes_long_before_the_instant_lets_nobody_wait_awake(slept):
    rtpu, clock = slept([-1_500_000])
    assert rtpu._sleep_until(2_000_000) is False
    assert clock.now_ns < 600_000


def spawn_all(unit, names):
    for name in names:
        unit.spawn(task=name)
        unit.hear(news.Initialised)


def test_a_prepared_switch_and_what_it_led_to_come_in_one_datagram(unit):  # law 6
    spawn_all(unit, ("count", "b", "c"))
    follows = command.Switch("flow0", (), (), (command.Launch("b", "", None, 2), command.Launch("c", "", None, 3)))
    unit.say(command.Switch("flow0", (), (), (command.Launch("count", "", None, 1),)))
    unit.say(command.PreparedSwitch("flow0", "count", 1, (command.Case(0, None, 4, follows),)))
    unit.hear(news.Cycled)
    reports, later = unit.batches(2)
    finished = reports[0]
    assert (finished.task, finished.switched) == ("count", 4)
    followed = [(type(report), report.task) for report in reports[1:]]
    assert followed[:2] == [(news.Changed, "b"), (news.Changed, "c")]
    assert {(news.Cycled, "b"), (news.Cycled, "c")} >= set(followed[2:])
    assert {report.task for report in later} <= {"b", "c"}


def test_a_finish_that_somebody_has_to_answer_waits_for_no_other_cycle(unit):  # law 2
    spawn_all(unit, ("count", "b"))
    unit.say(command.Switch("flow0", (), (), (command.Launch("count"), command.Launch("b"))))
    unit.hear(news.Cycled)
    unit._heard.clear()
    finishes = []
    while len(finishes) < 2:
        (reports,) = unit.batches(1)
        finishes += [reports] if any(isinstance(report, news.Finished) for report in reports) else []
    assert [len(batch) for batch in finishes] == [1, 1]


def test_it_says_that_it_is_alive_and_whose_code_runs(unit):  # law 30
    unit.spawn()
    unit.hear(news.Initialised)
    unit.say(command.Report())
    unit.hear(news.Statuses)  # the spawn is behind it
    beat = unit.heartbeat.last_ns
    assert beat > 0
    assert not unit.heartbeat.takes_long
    assert unit.heartbeat.task == ""


def test_code_that_cannot_be_loaded_is_refused(unit):  # law 21
    unit.spawn("class (")
    assert "count.py:1" in str(unit.hear(news.Refused).reason)


def test_commands_are_answered_while_tasks_cycle(unit):  # law 2
    unit.spawn(COUNT.replace("== 5", "== 1_000_000"))
    unit.hear(news.Initialised)
    unit.say(command.Switch("flow0", (), (), (command.Launch("count"),)))
    unit.hear(news.Cycled)
    unit.say(command.Report())
    (status,) = unit.hear(news.Statuses).tasks
    assert (status.task, status.state) == ("count", "ON")
    unit.say(command.Kill("flow0", "count"))
    assert unit.hear(news.Changed).state == "KILLED"


def test_quit_ends_it(unit):
    unit.say(command.Quit())
    unit.thread.join(20.0)
    assert not unit.thread.is_alive()


def test_it_ends_with_the_runtime_and_turns_its_tasks_off(unit):  # laws 17, 30
    unit.spawn(COUNT.replace("== 5", "== 1_000_000"))
    unit.hear(news.Initialised)
    unit.say(command.Switch("flow0", (), (), (command.Launch("count"),)))
    unit.hear(news.Cycled)
    unit.post.close()
    unit.thread.join(20.0)
    assert not unit.thread.is_alive()


def test_words_of_a_unit_travel():
    assert room.decode_news(room.encode([UnitReady({"SCHED_FIFO": True})])) == [UnitReady({"SCHED_FIFO": True})]
    assert room.decode_command(room.encode(Share("table:flow0"))) == Share("table:flow0")
