"""Processes of a runtime that were never started, and note what they are sent."""

from collections.abc import Callable
from typing import Any

from onika.words.reason import Reason


class NotedProcess:
    """Notes its orders, each with the descriptors that came along."""

    def __init__(self, name: str, title: Reason, decode: Callable[[bytes], Any]) -> None:
        self.name, self.title, self._decode = name, title, decode
        self.is_up = self.is_lost = self.is_ended = False
        self.orders: list[tuple[Any, ...]] = []
        self.post = self

    @property
    def kinds(self) -> list[str]:
        """What kinds of orders it was given."""
        return [type(order).__name__ for order, *_ in self.orders]

    def send(self, payload: bytes, descriptors: tuple[int, ...] = ()) -> None:
        """Note an order."""
        assert not self.is_lost, "nobody tells a dead process anything"
        self.orders.append((self._decode(payload), *descriptors))

    def end(self) -> None:
        """Note its end."""
        self.is_ended = True


class NotedSupervisor:
    """Notes what would be launched of this module; `refusal` is why not even that is possible."""

    def __init__(self, module: str, decode: Callable[[bytes], Any]) -> None:
        self._module, self._decode = module, decode
        self.processes: dict[str, NotedProcess] = {}
        self.launched: dict[str, tuple[Any, ...]] = {}
        self.refusal: Exception | None = None
        self.with_fifo = False

    def launch(
        self, name: str, title: Reason, module: str, arguments: tuple[str, ...] = (), *, has_modules: bool = False
    ) -> NotedProcess:
        """As `Supervisor.launch`."""
        assert module == self._module
        if self.refusal:
            raise self.refusal
        self.launched[name] = (*arguments, has_modules)
        self.processes[name] = NotedProcess(name, title, self._decode)
        return self.processes[name]
