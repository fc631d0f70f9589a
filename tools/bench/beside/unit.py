"""Tasks of a benchmark without files: a table, commands that spawn and switch, and a processing unit in wall time."""

import select
from collections.abc import Iterable
from time import monotonic_ns
from typing import TypeVar

from onika.host.units import rtpu
from onika.host.units.supervisor import Supervised, Supervisor
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.modules.code import load
from onika.runtime.table import SIZE, Table
from onika.words.fault import Fault

HOME = "bench"
_Kind = TypeVar("_Kind")


class Household:
    """One subsystem's table, and the commands that fill it with tasks."""

    def __init__(self) -> None:
        self.segment = Segment.create(HOME, SIZE)
        self.table = Table(self.segment)
        self.views = {f"table:{HOME}": self.segment.view}

    def spawn(
        self, task: str, source: str, frequency: float, rank: int = 0, aliases: dict[str, str] | None = None
    ) -> command.Spawn:
        """A periodic task of a module with this source; raises ValueError for one that cannot be loaded."""
        cls = load(source, f"{task}.py", task)
        if isinstance(cls, Fault):
            raise ValueError(str(cls))
        ports = []
        for attribute, declared in cls.declared_ports.items():
            port = declared.port(attribute)
            svar = (aliases or {}).get(port.name, port.name)
            entry = self.table.entry(svar, port.shape.resolve({}))
            ports.append(command.BoundPort(port.name, svar, str(entry.shape), entry.offset))
        return command.Spawn(
            HOME, task, task, f"{task}.py", source, "periodic", frequency, (), tuple(ports), rank, 0, None
        )

    def switch(self, on: Iterable[str] = (), off: Iterable[str] = ()) -> command.Switch:
        """Tasks off and on."""
        return command.Switch(HOME, tuple(off), (), tuple(command.Launch(name) for name in on))


class Unit:
    """A processing unit as the runtime starts it, and its post. Raises RuntimeError where it refuses or is gone."""

    def __init__(self, supervisor: Supervisor, name: str, house: Household) -> None:
        self._unit: Supervised = supervisor.launch(name, name, "onika.host.units.rtpu", ("--name", name))
        self.granted = self.hear(rtpu.UnitReady).granted
        self._unit.post.send(rtpu.encode(rtpu.Share(f"table:{HOME}")), (house.segment.fd,))

    def send(self, order: command.Command) -> None:
        """Give it a command."""
        self._unit.post.send(rtpu.encode(order))

    def spawn(self, order: command.Spawn) -> None:
        """Bring a task to life and wait for it."""
        self.send(order)
        self.hear(news.Initialised)

    def report(self) -> news.Statuses:
        """The figures of its tasks since the last report."""
        self.send(command.Report())
        return self.hear(news.Statuses)

    def hear(self, kind: type[_Kind]) -> _Kind:
        """The next news of a kind; others are passed over."""
        while True:
            for heard in self._next():
                if isinstance(heard, kind):
                    return heard
                if isinstance(heard, news.Refused | news.Failed):
                    raise RuntimeError(f"expected {kind.__name__}, found {heard}")

    def pass_time(self, until_ns: int) -> None:
        """Listen until this time of the monotonic clock, so that its post never fills up."""
        while (left := until_ns - monotonic_ns()) > 0:
            self._next(left * 1e-9)

    def _next(self, wait_s: float = 5.0) -> list[rtpu.UnitReady | news.News]:
        post = self._unit.post
        select.select([post], [], [], wait_s)
        received = post.receive()
        if received is None:
            if post.is_closed:
                raise RuntimeError("the processing unit is gone")
            return []
        return rtpu.decode_news(received[0])
