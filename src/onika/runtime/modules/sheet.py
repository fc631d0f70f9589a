"""The sheet of a module's class, read off the class and compared with `.rmod` files (law 24)."""

from collections.abc import Iterator
from typing import Any

from onika.model import parameter
from onika.model.port import PortKind
from onika.model.task import Task
from onika.runtime.modules.module import Module
from onika.wire.sheet import InputSheet, LocalSheet, ModuleSheet, PortSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of


def sheet_of(cls: type[Module]) -> ModuleSheet:
    """Read a class; raises ValueError where its declarations contradict each other."""
    for flag in ("trigger", "passive", "hardware"):
        if not isinstance(getattr(cls, flag), bool):
            raise ValueError(Reason.of("runtime.flag_kind", flag=flag, value=repr(getattr(cls, flag))))
    if not isinstance(cls.crit, int):
        raise ValueError(Reason.of("runtime.crit_kind", value=repr(cls.crit)))
    if cls.trigger and cls.passive:
        raise ValueError(Reason.of("runtime.trigger_and_passive"))
    ports = tuple(
        PortSheet(port.kind.value, port.name, str(port.shape), port.unit, port.meaning)
        for port in (declared.port(attribute) for attribute, declared in cls.declared_ports.items())
    )
    names = [port.name for port in ports]
    if len(set(names)) < len(names):
        raise ValueError(Reason.of("runtime.port_name_twice", names=tuple(sorted(names))))
    _check_steps(cls, {*names, *cls.declared_locals, "dt"})
    _check_bounds(cls, {port.name for port in ports if port.kind in ("INCONST", "INBOTH")})
    return ModuleSheet(
        ports,
        tuple(
            InputSheet(
                name,
                str(declared.shape),
                declared.unit,
                declared.meaning,
                declared.low,
                declared.high,
                _plain(declared.default),
            )
            for name, declared in cls.declared_inputs.items()
        ),
        tuple(
            LocalSheet(
                name,
                str(declared.shape),
                declared.unit,
                declared.meaning,
                _plain(declared.default),
                declared.low,
                declared.high,
            )
            for name, declared in cls.declared_locals.items()
        ),
        cls.trigger,
        cls.passive,
        cls.hardware,
        cls.crit,
        (cls.__doc__ or "").strip(),
    )


def differences(task: Task, sheet: ModuleSheet, place: Place) -> list[Fault]:
    """Everything in which a `.rmod` and its module's class differ: ports and their kinds, needed LOCAL lines."""
    reasons = [*_unlike_ports(task, sheet), *_unlike_parameters(task, sheet), *_unlike_device(task, sheet)]
    instead = Reason.of("runtime.task_left_out", task=task.name)
    return [Fault(place, reason, instead) for reason in reasons]


def _unlike_ports(task: Task, sheet: ModuleSheet) -> Iterator[Reason]:
    declared = {port.name: port.kind for port in sheet.ports}
    written = {name: kind.value for name, kind in task.kinds().items()}
    for name, kind in declared.items():
        if written.get(name) != kind:
            given = _declared_as(written.get(name))
            yield Reason.of("runtime.port_unlike", kind=kind, name=name, module=task.module, given=given)
    for name, kind in written.items():
        if name not in declared:
            yield Reason.of("runtime.port_undeclared", module=task.module, kind=kind, name=name)


def _unlike_parameters(task: Task, sheet: ModuleSheet) -> Iterator[Reason]:
    """The needed LOCAL lines that are missing, then those whose values do not fit."""
    given = {line.key for line in task.local}
    for local in sheet.locals:
        if local.default is None and local.name not in given:
            yield Reason.of("runtime.local_missing", name=local.name, shape=local.shape, meaning=local.meaning)
    by_name = {local.name: local for local in sheet.locals}
    for line in task.local:
        declared = by_name.get(line.key)
        if declared is None:
            continue
        try:
            parameter.check(declared, line.words)
        except ValueError as wrong:
            yield Reason.of("runtime.local_unfit", key=line.key, shape=declared.shape, why=reason_of(wrong))


def _unlike_device(task: Task, sheet: ModuleSheet) -> Iterator[Reason]:
    devices = [line for line in task.local if line.key == "DEVICE"]
    if sheet.hardware and not devices:
        yield Reason.of("runtime.device_missing")
    for line in devices:
        if len(line.words) != 1:
            yield _device_words(line.words)
    if sheet.hardware and task.frequency is not None and task.frequency < SLOWEST_HARDWARE_HZ:
        slowest = SLOWEST_HARDWARE_HZ
        yield Reason.of("runtime.hardware_too_slow", slowest_hardware_hz=slowest, frequency=task.frequency)


def strangers(task: Task, sheet: ModuleSheet) -> list[str]:
    """LOCAL lines that the module does not declare: kept in the file, but perhaps a typing mistake."""
    names = {local.name for local in sheet.locals} | {"DEVICE"}
    return [line.key for line in task.local if line.key not in names]


SLOWEST_HARDWARE_HZ = 40.0
"""Slower, and the drive would hold between two commands (law 17)."""


def _check_bounds(cls: type[Module], constants: set[str]) -> None:
    for name, declared in cls.declared_inputs.items():
        for bound in (declared.low, declared.high):
            if isinstance(bound, str) and bound not in constants:
                raise ValueError(Reason.of("runtime.input_bound_kind", name=name, bound=bound))


def _check_steps(cls: type[Module], names: set[str]) -> None:
    for attribute, declared in cls.declared_ports.items():
        if declared.step is None:
            continue
        name = declared.name or attribute
        if not (cls.hardware and declared.kind in (PortKind.INVAR, PortKind.INBOTH)):
            raise ValueError(Reason.of("runtime.step_place", name=name))
        for factor in declared.step if isinstance(declared.step, tuple) else (declared.step,):
            if isinstance(factor, str) and factor not in names:
                raise ValueError(Reason.of("runtime.step_factor", name=name, factor=factor))


def _declared_as(kind: str | None) -> Reason | str:
    if kind is None:
        return Reason.of("runtime.no_such_port")
    return kind


def _device_words(words: tuple[str, ...]) -> Reason:
    if words:
        return Reason.of("runtime.device_words", words=" ".join(words))
    return Reason.of("runtime.device_word_missing")


def _plain(value: Any) -> Any:
    """Defaults as plain lists and numbers, so that a sheet travels."""
    if value is None or isinstance(value, str | int | float | bool):
        return value
    return [_plain(item) for item in value]


__all__ = [
    "SLOWEST_HARDWARE_HZ",
    "InputSheet",
    "LocalSheet",
    "ModuleSheet",
    "PortKind",
    "PortSheet",
    "differences",
    "sheet_of",
]
