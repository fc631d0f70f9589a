"""A hop with iceoryx2: publish and subscribe for the value, its event service to wake the other; blocking wait."""

import ctypes
import os
import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import Any

import iceoryx2 as iox2

from beside.contestant import Figures, serve
from beside.hop.partner import either, start
from beside.hop.vector import SIZE, hops


class Vector(ctypes.Structure):
    """Six doubles in shared memory."""

    _fields_ = (("values", ctypes.c_double * SIZE),)


class End:
    """One end: a publisher with a notifier, a subscriber with a listener."""

    def __init__(self, prefix: str, root: str, out: str, back: str) -> None:
        iox2.set_log_level(iox2.LogLevel.Error)
        config = iox2.config.default()
        config.global_cfg.prefix = iox2.FileName.new(prefix)
        config.global_cfg.root_path = iox2.Path.new(root)
        self._node = iox2.NodeBuilder.new().config(config).create(iox2.ServiceType.Ipc)
        writes, reads = self._values(out), self._values(back)
        self.publisher = writes.publisher_builder().create()
        self.subscriber = reads.subscriber_builder().create()
        self._notifier = self._event(out).notifier_builder().create()
        self._listener = self._event(back).listener_builder().create()

    def send(self, values: Any) -> None:
        """Publish and wake."""
        self.publisher.loan_uninit().write_payload(Vector(values)).send()
        self._notifier.notify()

    def wait(self) -> Any:
        """Until woken, then the newest value: an array of ctypes."""
        while True:
            self._listener.blocking_wait()
            sample = self.subscriber.receive()
            if sample is not None:
                values = type(sample.payload().contents.values)(*sample.payload().contents.values)
                sample.delete()
                return values

    def _values(self, name: str) -> Any:
        builder = self._node.service_builder(iox2.ServiceName.new(name))
        return builder.publish_subscribe(Vector).open_or_create()

    def _event(self, name: str) -> Any:
        return self._node.service_builder(iox2.ServiceName.new(name)).event().open_or_create()


def contestant() -> None:
    """Sends first; what iceoryx2 leaves behind has a prefix of its own and is removed."""
    prefix = f"onika_bench_{os.getpid()}_"
    with tempfile.TemporaryDirectory() as root:
        end = End(prefix, root, "there", "back")
        other = start("beside.hop.iceoryx2_hop", (prefix, root))
        end.wait()  # the partner is there
        array = ctypes.c_double * SIZE

        def there_and_back(values: list[float]) -> list[float]:
            end.send(array(*values))
            return list(end.wait())

        def measure(count: int) -> Figures:
            return hops(there_and_back, count)

        serve(version("iceoryx2"), measure)
        other.kill()
        other.wait()
    for left in Path("/dev/shm").glob(f"{prefix}*"):
        left.unlink()


def partner(words: list[str]) -> None:
    """Sends back what it gets."""
    end = End(words[0], words[1], "back", "there")
    end.send((ctypes.c_double * SIZE)())
    while True:
        end.send(end.wait())


if __name__ == "__main__":
    either(contestant, partner)
