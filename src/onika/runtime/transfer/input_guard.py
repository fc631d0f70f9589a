"""The input guard of a hardware task: its inputs are fresh, finite, and go over without a jump (laws 4, 5, 33)."""

from onika.runtime.device import SILENCE_NS
from onika.runtime.error import LawBroken
from onika.runtime.modules.binding import Binding
from onika.runtime.modules.module import Module
from onika.runtime.transfer.bumpless_channel import BLENDED_NS
from onika.runtime.transfer.bumpless_transfer import BumplessTransfer, bumpless_channels
from onika.words.reason import Reason

LATE_NS = 30_000_000
"""Who has not looked at its device for so long was kept waiting itself: then the machine is late, not the device."""


class InputGuard:
    """Takes the inputs in, in place of the task; `table` is the memory in which they lie."""

    def __init__(self, subsystem: str, task: str, module: Module, period_ns: int, table: memoryview) -> None:
        self.transfer = BumplessTransfer(subsystem, task, (), period_ns)
        self.is_waiting = False
        """Whether it holds: until every input was written anew, and does not tear the device out of its hold."""
        self._address = subsystem, task
        self._module = module
        self._period_ns = period_ns
        self._looked_ns = 0
        self._watched_until = table[:8].cast("q")

    def bind(self, binding: Binding) -> None:
        """Take in the inputs of this binding."""
        self._binding = binding
        self._reads = binding.copies("in")
        self._rings = binding.input_rings

    def prepare(self) -> None:
        """After `init`: how far inputs may step is known; raises ValueError where it is no positive number."""
        tell = self.transfer.tell
        channels = bumpless_channels(self._module, self._binding)
        self.transfer = BumplessTransfer(*self._address, channels, self._period_ns)
        self.transfer.tell = tell

    def change_rate(self, period_ns: int) -> None:
        """Another rate from the next cycle on."""
        self._period_ns = period_ns
        self.transfer.change_rate(self._module, period_ns)

    def begin(self, now: int) -> None:
        """The task comes on: it holds until every input was written anew."""
        device = self._module.device
        self._marks = [ring.count for ring in self._rings]
        self.is_waiting, self._patient_until = bool(self._marks), 0
        device.holding(self.is_waiting)
        device.listen_from(now)
        self._looked_ns = now

    def take_in(self, now: int) -> bool:
        """Copy in; False where the task has to hold. Raises LawBroken for what it cannot be given."""
        transfer, was_waiting = self.transfer, self.is_waiting
        is_fresh = was_waiting and self._are_fresh()
        is_watched = not was_waiting and now <= self._watched_until[0]
        if is_watched or transfer.is_open:
            transfer.keep()
        for read in self._reads:
            read()
        self._module.now = now * 1e-9
        self._check_device(now)
        if was_waiting and not is_fresh:
            return False
        self._check_values()
        if was_waiting and not self._begins(now):
            return False
        if is_watched or was_waiting or transfer.is_open:
            transfer.pass_on(now, is_watched or was_waiting)
        return True

    def rest(self) -> None:
        """The task holds: what was watched is over."""
        if self.transfer.is_open:
            self.transfer.close()

    def _check_device(self, now: int) -> None:
        device = self._module.device
        away_ns, self._looked_ns = now - self._looked_ns, now
        if device.silent_ns(now) > SILENCE_NS:
            key = "runtime.device_silent_late" if away_ns > LATE_NS else "runtime.device_silent"
            raise LawBroken(Reason.of(key, name=device.sheet.name, ms=SILENCE_NS // 1_000_000))

    def _check_values(self) -> None:
        bad = self._binding.not_finite()
        if bad:
            raise LawBroken(Reason.of("runtime.inputs_not_finite", names=tuple(bad)))

    def _are_fresh(self) -> bool:
        """Before the inputs are copied in: a value written meanwhile may only be newer than what is counted here."""
        return all(ring.count != mark for ring, mark in zip(self._rings, self._marks, strict=True))

    def _begins(self, now: int) -> bool:
        """Whether the hold is over: inputs are near to what holds the device, or have had the time to come there.

        What measures speeds sees a jump where the device has moved while nobody read it.
        """
        self._patient_until = self._patient_until or now + BLENDED_NS
        is_near = self.transfer.come_from_hold(self._module)
        self.is_waiting = not is_near and now < self._patient_until
        self._module.device.holding(self.is_waiting)
        return not self.is_waiting
