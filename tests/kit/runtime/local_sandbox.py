"""A sandbox without a process: messages go through bytes as they would, and are answered here.

sandbox = LocalSandbox(spawn)
cls = load_sandboxed(spawn, sandbox)
"""

from collections.abc import Mapping
from typing import Any

from msgspec import structs

from onika.runtime.command import Spawn
from onika.runtime.error import LawBroken
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.sandbox.confined_instance import ConfinedInstance
from onika.runtime.sandbox.sandbox_messages import Load, decode_order, encode
from onika.runtime.sandbox.sandboxed_module import CYCLE, CYCLE_LETTER, NOTHING_CAME_OF_IT
from onika.words.fault import Fault

_BYTES = 1 << 22


class LocalSandbox:
    """`answers` are given in place of what would be answered, one after the other; None: it has ended."""

    def __init__(self, spawn: Spawn, answers: list[bytes | None] | None = None) -> None:
        self.memory = memoryview(bytearray(_BYTES))
        self.is_closed = False
        self.is_heard = True
        self.asked: list[bytes] = []
        self._answers = answers or []
        self._instance = ConfinedInstance(self.memory)
        self._loaded = encode(self._instance.answer(decode_order(encode(Load(spawn)))))

    def answer(self, patience_s: float) -> bytes:
        """What came of loading."""
        return self._planted(self._loaded)

    def ask(self, message: bytes, patience_s: float) -> bytes:
        """The answer to a message, as its process would give it."""
        self.asked.append(message)
        if message[:1] == CYCLE_LETTER:
            _, now, published = CYCLE.unpack(message)
            returned = self._instance.cycle(now, published)
            return self._planted(NOTHING_CAME_OF_IT if returned is None else encode(returned))
        return self._planted(encode(self._instance.answer(decode_order(message))))

    def close(self) -> None:
        """It is not asked any more."""
        self.is_closed = True

    def _planted(self, answer: bytes) -> bytes:
        planted = self._answers.pop(0) if self._answers else answer
        if planted is None:
            raise LawBroken("the sandbox has ended")
        return planted


def sandboxed(spawn: Spawn) -> Spawn:
    """The same task, whose module is in a sandbox."""
    cls = load(spawn.source, spawn.path, spawn.module)
    if isinstance(cls, Fault):
        raise ValueError(str(cls.sentence))
    device = spawn.device and structs.replace(spawn.device, identity=_plain(spawn.device.identity))
    return structs.replace(spawn, device=device, sandboxed_as=sheet_of(cls))


def _plain(identity: Mapping[str, Any]) -> dict[str, tuple[float, ...] | str]:
    """What a device says of itself, as it travels."""
    return {name: value if isinstance(value, str) else tuple(value) for name, value in identity.items()}
