"""A bench for one module: its inputs are set by hand, its outputs read, its entry points run, without a runtime.

    bench = Bench("module/wave.py", frequency=100, local={"AMPLITUDE": 2.0})
    bench.init().on("0.5 10").cycle(25)
    assert bench["Y"] == …

The module lives in the same executive as on an RTPU, so the law of the cycle holds here too: nothing is imitated but
the table's other users, time and the device.
"""

import weakref
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Self, TypeVar

import numpy as np

from onika.model.lifecycle import State
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.execution.executive import Executive
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.modules.binding import locals_of
from onika.runtime.modules.code import load
from onika.runtime.modules.module import Module
from onika.runtime.table import Table
from onika.testing.bench_device import SEGMENT, BenchDevice
from onika.words.fault import Fault
from onika.words.reason import Reason
from onika.words.shape import Shape

_Kind = TypeVar("_Kind")
_HOME, _TASK = "bench", "module"
_TABLE_BYTES = 1 << 22
_SECOND = 1_000_000_000


class Bench:
    """One module under test, by its file. Raises ValueError for a file that is no module and for bad LOCAL lines.

    `frequency` in Hz (None: aperiodic; with `is_synchronous` the task is a synchronous one, whose `event` the test
    leads), `local` the LOCAL lines by name, `constants` the INCONSTs by name and whatever shapes need. Inputs are set
    and outputs read by index: `bench["Q_MEZ"] = [0.0] * 6`. Calls chain.
    """

    def __init__(
        self,
        file: str | Path,
        *,
        frequency: float | None = 100.0,
        local: Mapping[str, object] | None = None,
        constants: Mapping[str, Any] | None = None,
        device: BenchDevice | None = None,
        seed: int = 0,
        is_synchronous: bool = False,
    ) -> None:
        self.path = Path(file)
        self.now_ns = 0
        self.cycles = 0
        self.news: list[news.News] = []
        self._source = self.path.read_text(encoding="utf-8")
        self._frequency, self._device, self._seed = frequency, device, seed
        self._is_synchronous = is_synchronous
        self._local = tuple((key, _words(value)) for key, value in (local or {}).items())
        self.cls = _class_of(self._source, self.path)
        segment = Segment.create(_HOME, _TABLE_BYTES)
        weakref.finalize(self, segment.close)
        self.table = Table(segment)
        views = {f"table:{_HOME}": segment.view}
        if device is not None:
            views[SEGMENT] = device.view
        self._executive = Executive(_HOME, views)
        identity = {} if device is None else device.sheet.identity
        stated = self.cls.constants(locals_of(self.cls, dict(self._local)), identity)
        self._constants = {**stated, **(constants or {})}
        self._ports = self._lay_ports(self.cls)

    # Variables

    def __setitem__(self, name: str, value: Any) -> None:
        entry = self._entry(name)
        self.table.ring(name).write(_bytes_of(value, entry.shape))

    def __getitem__(self, name: str) -> Any:
        self._entry(name)
        return self.table.value(name)

    def forget(self, *names: str) -> Self:
        """Say that these variables steer nothing any more, as after a hold of the hardware (`Module.continues`)."""
        return self._handle(command.Switch(_HOME, (), names, ()))

    # Entry points

    def init(self) -> Self:
        """Load the module and initialise it."""
        return self._handle(self._spawn_of(self.path, self._source, self._ports))

    def on(self, line: str = "") -> Self:
        """Turn it on with this argument line; without a fitting one it asks (`asked`)."""
        self._publish()
        return self._handle(command.Switch(_HOME, (), (), (command.Launch(_TASK, line),)))

    def answer(self, line: str) -> Self:
        """Answer what it asked."""
        return self._handle(command.Answer(_HOME, _TASK, line))

    def cycle(self, count: int = 1) -> Self:
        """Run so many cycles, fewer if it leaves ON meanwhile; raises RuntimeError where it is not ON to begin with."""
        if self.state is not State.ON:
            why = self.why or Reason.of("runtime.bench_turn_on")
            raise RuntimeError(Reason.of("runtime.bench_not_on", state=self.state.value, why=why))
        for _ in range(count):
            due = self._executive.next_release()
            if due is None:
                break
            self.now_ns = due
            self._publish()
            self.news += self._executive.run_next(due) or []
            self.cycles += 1
        return self

    def event(self) -> Self:
        """The event of a synchronous task has come; where it has a partner that is what this has said, if anything."""
        self.news += self._executive.event((_HOME, _TASK), self.now_ns)
        return self

    def off(self) -> Self:
        """Turn it off."""
        return self._handle(command.Switch(_HOME, (_TASK,), (), ()))

    def clear(self) -> Self:
        """Bring it out of ERROR."""
        return self._handle(command.Clear(_HOME, _TASK))

    def kill(self) -> Self:
        """End it."""
        return self._handle(command.Kill(_HOME, _TASK))

    def swap(self, file: str | Path) -> Self:
        """Exchange its module for that of another file while it lives; `why` tells a refusal."""
        path = Path(file)
        source = path.read_text(encoding="utf-8")
        spawn = self._spawn_of(path, source, self._lay_ports(_class_of(source, path)))
        return self._handle(command.Swap(spawn))

    def get(self, name: str) -> Any:
        """What the module's `get` answers; raises RuntimeError with its refusal."""
        return self._asked_for(command.Get(_HOME, _TASK, name))

    def set(self, name: str, value: str) -> Any:
        """Tell the module's `set`; raises RuntimeError with its refusal."""
        return self._asked_for(command.Set(_HOME, _TASK, name, value))

    # What came of it

    @property
    def now(self) -> float:
        """Seconds since the start."""
        return self.now_ns / _SECOND

    @property
    def task(self) -> RunningTask | None:
        """The live task, once it was spawned."""
        return self._executive.tasks.get((_HOME, _TASK))

    @property
    def state(self) -> State:
        """Its state; KILLED where it never came to life."""
        return self.task.state if self.task else State.KILLED

    @property
    def finished(self) -> news.Finished | None:
        """The FINISH signal, if it came."""
        return self._last(news.Finished)

    @property
    def failed(self) -> news.Failed | None:
        """The last error: `text`, `path`, `line`, `traceback`."""
        return self._last(news.Failed)

    @property
    def asked(self) -> news.Asked | None:
        """The last question to the user; `reason` says what was wrong with the argument line."""
        return self._last(news.Asked)

    @property
    def warnings(self) -> list[str]:
        """The texts of all warnings."""
        return [str(one.text) for one in self.news if isinstance(one, news.Warned)]

    @property
    def why(self) -> str:
        """The last refusal, error or question as a sentence; empty if there was none."""
        for one in reversed(self.news):
            if isinstance(one, news.Failed):
                return str(one.text)
            if isinstance(one, news.Refused | news.Asked):
                return str(one.reason)
        return ""

    # Inner

    def _spawn_of(self, path: Path, source: str, ports: tuple[command.BoundPort, ...]) -> command.Spawn:
        device = None if self._device is None else self._device.grant()
        kind = "synchronous" if self._is_synchronous else "periodic" if self._frequency else "aperiodic"
        return command.Spawn(
            _HOME, _TASK, path.stem, str(path), source, kind, self._frequency, self._local,
            ports, 0, self._seed, device,
        )  # fmt: skip

    def _lay_ports(self, cls: type[Module]) -> tuple[command.BoundPort, ...]:
        """Entries for all ports, their shapes resolved by `constants` and by what a robot module says of itself."""
        declared, known = [one.port(attribute) for attribute, one in cls.declared_ports.items()], self._constants
        ports = []
        for port in declared:
            entry = self.table.entry(port.name, port.shape.resolve(known))
            ports.append(command.BoundPort(port.name, port.name, str(entry.shape), entry.offset))
            if port.kind.is_input and port.kind.at_init and port.name in known:
                self[port.name] = known[port.name]
        return tuple(ports)

    def _entry(self, name: str) -> Any:
        if name not in self.table.entries:
            raise KeyError(str(Reason.of("runtime.bench_variable", names=tuple(self.table.entries), name=name)))
        return self.table.entries[name]

    def _publish(self) -> None:
        if self._device is not None:
            self._device.publish(self.now_ns)

    def _handle(self, order: command.Command) -> Self:
        self.news += self._executive.handle(order, self.now_ns)
        return self

    def _asked_for(self, order: command.Command) -> Any:
        answer = self._executive.handle(order, self.now_ns)[-1]
        if isinstance(answer, news.Got):
            return answer.value
        raise RuntimeError(answer.reason if isinstance(answer, news.Refused) else str(answer))

    def _last(self, kind: type[_Kind]) -> _Kind | None:
        messages = (news.in_english(one) for one in reversed(self.news) if isinstance(one, kind))
        return next((one for one in messages if isinstance(one, kind)), None)


def _class_of(source: str, path: Path) -> type[Module]:
    cls = load(source, str(path), path.stem)
    if isinstance(cls, Fault):
        raise ValueError(str(cls))
    return cls


def _words(value: object) -> tuple[str, ...]:
    if isinstance(value, str):
        return tuple(value.split())
    if isinstance(value, Iterable):
        return tuple(str(one) for one in value)
    return (str(value),)


def _bytes_of(value: Any, shape: Shape) -> bytes:
    """A value as the table holds it; raises ValueError where it does not fit."""
    if shape.type.is_text:
        data = str(value).encode()
        if len(data) >= shape.size:
            raise ValueError(Reason.of("runtime.bench_text", most=shape.size - 1, count=len(data)))
        return data.ljust(shape.size, b"\0")
    if shape.type.value == "char":
        return bytes([ord(value)])
    array = np.zeros(tuple(map(int, shape.dims)), dtype=shape.type.code)
    array[...] = value
    return array.tobytes()
