"""A table and a device for one running task, which a test carries out entry point by entry point."""

from array import array

from onika.module import Module
from onika.ring.segment import Segment
from onika.runtime.command import BoundPort, Spawn
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.table import Table
from onika.testing.bench_device import SEGMENT, BenchDevice
from onika.words.shape import Shape


class Place:
    """A table and a device for one task."""

    def __init__(self) -> None:
        self.segment = Segment.create("test", 1 << 18)
        self.table = Table(self.segment)
        self.device = BenchDevice(("x",), ("force",))

    def task(
        self,
        cls: type[Module],
        frequency: float = 100.0,
        with_device: bool = False,
        shapes: dict[str, int] | None = None,
    ) -> RunningTask:
        """A task of a module class, its ports bound to entries of the table."""
        ports = []
        for attribute, declared in cls.declared_ports.items():
            port = declared.port(attribute)
            shape = port.shape.resolve(shapes or {})
            ports.append(BoundPort(port.name, port.name, str(shape), self.table.entry(port.name, shape).offset))
        grant = self.device.grant() if with_device else None
        spawn = Spawn("s", "t", "m", "m.py", "", "periodic", frequency, (), tuple(ports), 0, 0, grant)
        return RunningTask(spawn, cls, {"table:s": self.segment.view, SEGMENT: self.device.view})

    def write(self, **values: float) -> None:
        """Write numbers to the variables of these names."""
        for name, value in values.items():
            self.table.entry(name, Shape.parse("double"))
            self.table.ring(name).write(memoryview(array("d", [value])))
