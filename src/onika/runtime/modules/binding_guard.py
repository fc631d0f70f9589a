"""The binding guard: it finds what a module may not do to itself while it lives, such as replacing a bound port."""

from collections.abc import Collection

from onika.runtime.declaration import PortDeclaration, slot
from onika.runtime.error import LawBroken
from onika.runtime.modules.binding import undeclared
from onika.runtime.modules.module import Module
from onika.words.reason import Reason

_FLAGS = ("trigger", "passive", "hardware", "crit")


class BindingChanged(LawBroken):
    """A module has changed what it is bound to, or writes what is no port."""


class BindingGuard:
    """Remembers an instance as it was bound; `known` are the variables of its subsystem, as they come to be known."""

    def __init__(self, instance: Module) -> None:
        self._instance = instance
        self._class = type(instance)
        self._ports = dict(self._class.declared_ports)
        self._flags = {flag: getattr(self._class, flag) for flag in _FLAGS}
        self._buffers = {port: getattr(instance, slot(port)) for port in self._ports}
        self.known: Collection[str] = ()

    def check(self) -> None:
        """Raises BindingChanged with everything that is wrong."""
        faults = self.faults()
        if faults:
            raise BindingChanged(Reason.of("runtime.several", reasons=tuple(faults)))

    def faults(self) -> list[Reason]:
        """Everything that is wrong by now, as sentences."""
        return [*self._strays(), *self._class_faults(), *self._lost_buffers()]

    def _strays(self) -> list[Reason]:
        names = undeclared(self._instance)
        foreign = [name for name in names if name in self.known]
        others = tuple(name for name in names if name not in self.known)
        faults = [Reason.of("runtime.foreign_variable", name=name) for name in foreign]
        if others:
            faults.append(Reason.of("runtime.stray_names", names=others))
        return faults

    def _class_faults(self) -> list[Reason]:
        cls = type(self._instance)
        if cls is not self._class:
            return [Reason.of("runtime.turned_into", former=self._class.__name__, now=cls.__name__)]
        faults = []
        late = {name for name, declaration in vars(cls).items() if isinstance(declaration, PortDeclaration)}
        changed = sorted(late | {name for name in (*self._ports, *cls.declared_ports) if self._is_changed(name)})
        if changed:
            faults.append(Reason.of("runtime.declared_late", names=tuple(changed)))
        flags = [flag for flag, value in self._flags.items() if getattr(self._instance, flag) != value]
        if flags:
            faults.append(Reason.of("runtime.flags_changed", names=tuple(flags)))
        return faults

    def _is_changed(self, port: str) -> bool:
        now = self._class.declared_ports.get(port)
        return now is not self._ports.get(port) or not isinstance(getattr(self._class, port, None), property)

    def _lost_buffers(self) -> list[Reason]:
        own = vars(self._instance)
        lost = sorted(port for port, buffer in self._buffers.items() if own.get(slot(port)) is not buffer)
        if lost:
            return [Reason.of("runtime.memory_exchanged", names=tuple(lost))]
        return []
