"""The binding guard: it finds what a module may not do to itself while it lives, such as replacing a bound port."""

from collections.abc import Collection
from itertools import starmap
from operator import attrgetter, is_
from types import MappingProxyType
from typing import Any

from onika.runtime.declaration import PortDeclaration, slot
from onika.runtime.error import LawBroken
from onika.runtime.modules.binding import undeclared
from onika.runtime.modules.module import Module
from onika.words.reason import Reason

_FLAGS = ("trigger", "passive", "hardware", "crit")


_flags_of = attrgetter(*_FLAGS)


class BindingChanged(LawBroken):
    """A module has changed what it is bound to, or writes what is no port."""


class BindingGuard:
    """Remembers an instance as it was bound; `known` are the variables of its subsystem, as they come to be known."""

    def __init__(self, instance: Module) -> None:
        self._instance = instance
        self._class = type(instance)
        self._ports = dict(self._class.declared_ports)
        self._flags = {flag: getattr(self._class, flag) for flag in _FLAGS}
        self._flag_values = tuple(self._flags.values())
        self._buffers = {slot(port): getattr(instance, slot(port)) for port in self._ports}
        self._definitions = tuple((vars(cls), tuple(vars(cls).values())) for cls in _own_classes(self._class))
        self._harmless: Collection[str] = ()
        """The attributes that the instance had when it was last looked at, and no fault was found."""
        self.known: Collection[str] = ()

    def check(self) -> None:
        """Raises BindingChanged with everything that is wrong."""
        faults = self.faults()
        if faults:
            raise BindingChanged(Reason.of("runtime.several", reasons=tuple(faults)))

    def faults(self) -> list[Reason]:
        """Everything that is wrong by now, as sentences."""
        if self._is_unchanged():
            return []
        faults = [*self._strays(), *self._class_faults(), *self._lost_buffers()]
        self._harmless = () if faults else frozenset(vars(self._instance))
        return faults

    def _is_unchanged(self) -> bool:
        """Whether all is the same objects as before: asked first, since every switch looks at every task it turns."""
        instance, own = self._instance, vars(self._instance)
        return (
            own.keys() == self._harmless
            and type(instance) is self._class
            and all(map(is_, map(own.get, self._buffers), self._buffers.values()))
            and all(starmap(_holds, self._definitions))
            and self._class.declared_ports.keys() == self._ports.keys()
            and all(map(is_, map(self._class.declared_ports.get, self._ports), self._ports.values()))
            and _flags_of(instance) == self._flag_values
        )

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
        lost = sorted(port for port in self._ports if own.get(slot(port)) is not self._buffers[slot(port)])
        if lost:
            return [Reason.of("runtime.memory_exchanged", names=tuple(lost))]
        return []


def _own_classes(cls: type[Module]) -> list[type]:
    """The class of a module and those of its author's that it stands on."""
    return [base for base in cls.__mro__ if base not in Module.__mro__]


def _holds(now: MappingProxyType[str, Any], then: tuple[Any, ...]) -> bool:
    """Whether a class holds the very objects that it held then."""
    return len(now) == len(then) and all(map(is_, now.values(), then))
