"""The input guard by itself: what it does in each cycle, with time handed in (laws 4, 5, 33)."""

from types import SimpleNamespace

import pytest

from onika.runtime.error import LawBroken
from onika.runtime.transfer import input_guard
from onika.runtime.transfer.input_guard import InputGuard
from onika.words.reason import Reason

MS = 1_000_000
WATCHED_UNTIL = 5000


class Transfer:
    """Notes what it is told; `is_near` says whether the inputs are near to what holds the device."""

    def __init__(self, *arguments):
        self.arguments = arguments
        self.tell = None
        self.is_open = False
        self.is_near = True
        self.calls = []

    def keep(self):
        self.calls.append("keep")

    def come_from_hold(self, module):
        self.calls.append(("come from hold", module.name))
        return self.is_near

    def pass_on(self, now, is_watched):
        self.calls.append(("pass on", now, is_watched))

    def change_rate(self, module, period_ns):
        self.calls.append(("rate", module.name, period_ns))

    def close(self):
        self.calls.append("close")


class Device:
    """Silent for as long as a test says; notes whether commands are turned into holds."""

    sheet = SimpleNamespace(name="arm")

    def __init__(self):
        self.silence_ns = 0
        self.holds = []
        self.listened = []

    def holding(self, is_holding):
        self.holds.append(is_holding)

    def listen_from(self, now):
        self.listened.append(now)

    def silent_ns(self, now):
        self.looked_ns = now
        return self.silence_ns


class Binding:
    """Two inputs, whose writes are counted."""

    def __init__(self):
        self.input_rings = [SimpleNamespace(count=3), SimpleNamespace(count=8)]
        self.bad = []
        self.reads = 0

    def copies(self, direction):
        assert direction == "in"
        return [self.read]

    def read(self):
        self.reads += 1

    def not_finite(self):
        return self.bad

    def write(self, *numbers):
        for number in numbers:
            self.input_rings[number].count += 1


@pytest.fixture
def binding():
    return Binding()


@pytest.fixture
def module():
    return SimpleNamespace(name="arm", device=Device(), now=0.0)


@pytest.fixture
def guard(monkeypatch, module, binding):
    monkeypatch.setattr(input_guard, "BumplessTransfer", Transfer)
    monkeypatch.setattr(input_guard, "bumpless_channels", lambda module, binding: (module, binding))
    table = bytearray(16)
    memoryview(table).cast("q")[0] = WATCHED_UNTIL
    guard = InputGuard("s", "arm", module, 2 * MS, memoryview(table))
    guard.bind(binding)
    return guard


def test_before_it_is_prepared_it_waits_for_nothing_and_has_no_channels(guard):
    assert guard.is_waiting is False
    assert guard.transfer.arguments == ("s", "arm", (), 2 * MS)


def test_it_knows_its_channels_once_prepared_and_tells_of_them_whom_it_told_before(guard, module, binding):  # R-X04
    guard.transfer.tell = print
    guard.prepare()
    assert guard.transfer.arguments == ("s", "arm", (module, binding), 2 * MS)
    assert guard.transfer.tell is print


def test_another_rate_holds_for_what_is_there_and_for_what_comes(guard):  # R-X04
    guard.change_rate(4 * MS)
    assert guard.transfer.calls == [("rate", "arm", 4 * MS)]
    guard.prepare()
    assert guard.transfer.arguments[-1] == 4 * MS


def test_who_comes_on_turns_commands_into_holds_and_counts_silence_anew(guard, module):  # laws 4, 17
    guard.begin(700)
    assert guard.is_waiting is True
    assert (module.device.holds, module.device.listened) == ([True], [700])


def test_who_reads_nothing_waits_for_nothing(guard, module, binding):  # law 4
    binding.input_rings.clear()
    guard.begin(700)
    assert guard.is_waiting is False
    assert module.device.holds == [False]
    assert guard.take_in(10_000) is True


def test_it_holds_until_the_last_of_its_inputs_was_written(guard, module, binding):  # law 4
    guard.begin(0)
    assert guard.take_in(1) is False
    binding.write(0)
    assert guard.take_in(2) is False
    binding.write(1)
    assert guard.take_in(3) is True
    assert module.device.holds == [True, False]
    assert (guard.is_waiting, binding.reads) == (False, 3)
    assert guard.transfer.calls == [("come from hold", "arm"), ("pass on", 3, True)]


def test_what_is_written_while_it_reads_counts_in_the_next_cycle(guard, binding):  # law 4
    guard.begin(0)
    read = binding.read
    guard._reads[:] = [lambda: (read(), binding.write(0, 1))]
    assert guard.take_in(1) is False
    assert guard.take_in(2) is True


def test_what_lay_there_before_may_be_no_number(guard, binding):  # laws 4, 5
    binding.bad = ["Q_REF"]
    guard.begin(0)
    assert guard.take_in(1) is False
    binding.write(0, 1)
    with pytest.raises(LawBroken) as broken:
        guard.take_in(2)
    assert broken.value.args[0] == Reason.of("runtime.inputs_not_finite", names=("Q_REF",))


def test_what_is_far_from_the_hold_is_waited_for_a_tenth_of_a_second_and_no_longer(guard, module, binding):  # R-X04
    guard.begin(0)
    binding.write(0, 1)
    guard.transfer.is_near = False
    begun = 40 * MS
    instants = (begun, begun + 60 * MS, begun + 100 * MS - 1)
    assert [guard.take_in(now) for now in instants] == [False] * 3
    assert module.device.holds == [True] * 4
    assert guard.take_in(begun + 100 * MS) is True
    assert (guard.is_waiting, module.device.holds[-1]) == (False, False)
    assert guard.transfer.calls[-1] == ("pass on", begun + 100 * MS, True)


def test_who_comes_on_again_is_waited_for_anew(guard, binding):  # R-X04
    for begun in (0, 500 * MS):
        guard.begin(begun)
        binding.write(0, 1)
        guard.transfer.is_near = False
        assert [guard.take_in(begun + later) for later in (0, 99 * MS, 104 * MS)] == [False, False, True]


def test_what_comes_near_meanwhile_ends_the_hold(guard, module, binding):  # R-X04
    guard.begin(0)
    binding.write(0, 1)
    guard.transfer.is_near = False
    assert guard.take_in(1) is False
    guard.transfer.is_near = True
    assert guard.take_in(2) is True
    assert module.device.holds[-1] is False


def test_after_a_reconfiguration_inputs_are_watched_up_to_its_last_instant(guard):  # R-X04
    for now in (WATCHED_UNTIL - 1, WATCHED_UNTIL):
        guard.take_in(now)
        assert guard.transfer.calls == ["keep", ("pass on", now, True)]
        guard.transfer.calls.clear()
    guard.take_in(WATCHED_UNTIL + 1)
    assert guard.transfer.calls == []


def test_what_was_begun_is_brought_to_its_end_when_nobody_watches_any_more(guard):  # R-X04
    guard.transfer.is_open = True
    guard.take_in(WATCHED_UNTIL + 1)
    assert guard.transfer.calls == ["keep", ("pass on", WATCHED_UNTIL + 1, False)]


def test_who_waits_does_not_keep_what_nobody_was_given(guard):  # R-X04
    guard.begin(0)
    assert guard.take_in(1) is False
    assert guard.transfer.calls == []


def test_a_module_sees_seconds(guard, module):  # law 13
    guard.take_in(1_500_000_000)
    assert module.now == 1.5


def test_a_device_may_be_silent_for_sixty_milliseconds_and_no_longer(guard, module):  # law 17
    module.device.silence_ns = 60 * MS
    assert guard.take_in(7) is True
    assert module.device.looked_ns == 7
    module.device.silence_ns += 1
    with pytest.raises(LawBroken) as broken:
        guard.take_in(8)
    assert broken.value.args[0] == Reason.of("runtime.device_silent", name="arm", ms=60)


@pytest.mark.parametrize(("away_ns", "key"), [(30 * MS, "device_silent"), (30 * MS + 1, "device_silent_late")])
def test_it_is_said_whether_the_device_was_late_or_the_machine_with_it(guard, module, away_ns, key):  # law 17, R-X06
    guard.take_in(500 * MS)
    module.device.silence_ns = 60 * MS + 1
    with pytest.raises(LawBroken) as broken:
        guard.take_in(500 * MS + away_ns)
    assert broken.value.args[0].key == f"runtime.{key}"


def test_the_time_before_the_task_came_on_is_no_lateness_of_the_machine(guard, module):  # law 17, R-X06
    guard.take_in(0)
    guard.begin(500 * MS)
    module.device.silence_ns = 60 * MS + 1
    with pytest.raises(LawBroken) as broken:
        guard.take_in(510 * MS)
    assert broken.value.args[0].key == "runtime.device_silent"


def test_a_silent_device_is_a_fault_of_who_still_waits_too(guard, module):  # law 17
    guard.begin(0)
    module.device.silence_ns = 60 * MS + 1
    with pytest.raises(LawBroken):
        guard.take_in(1)


def test_who_rests_ends_what_was_watched(guard):  # R-X04
    guard.rest()
    assert guard.transfer.calls == []
    guard.transfer.is_open = True
    guard.rest()
    assert guard.transfer.calls == ["close"]
