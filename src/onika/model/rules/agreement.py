"""Whether tasks agree on what the variables are that they share, and claim no device twice (laws 7 and 16).

As far as their modules were read. What is asked again and again is prepared once for a library: a variable about which
all agree, and a device that one task names, need never be looked at again.
"""

from collections.abc import Iterable, Mapping
from typing import Protocol

from onika.model.task import Task
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.shape import Shape


class DeclaredPort(Protocol):
    """A port as a module declares it; its shape as text."""

    @property
    def name(self) -> str:
        """The coded name."""

    @property
    def shape(self) -> str:
        """As in `double[NDOF]`."""

    @property
    def unit(self) -> str:
        """As in `rad/s`."""


Users = Mapping[str, str]
"""By task: what it takes a variable for, as in `double[NDOF] in rad`."""


def declared(task: Task, ports: Iterable[DeclaredPort]) -> dict[str, str]:
    """What a task takes its variables for, by their aliased names."""
    aliases = dict(task.aliases)
    return {aliases.get(port.name, port.name): f"{_aliased(port.shape, aliases)} in {port.unit}" for port in ports}


def contested(tasks: Mapping[str, Mapping[str, str]]) -> dict[str, Users]:
    """The variables about which tasks disagree, with what each takes them for; `tasks` say what they declare."""
    users: dict[str, dict[str, str]] = {}
    for name, variables in tasks.items():
        for svar, kind in variables.items():
            users.setdefault(svar, {})[name] = kind
    return {svar: kinds for svar, kinds in users.items() if len(set(kinds.values())) > 1}


def disagreements(name: str, svar: str, users: Users, standing: Iterable[str]) -> tuple[Refusal, ...]:
    """Why a task would not run beside others that use a contested variable."""
    kind = users[name]
    return tuple(
        Refusal(
            Reason.of("rules.kinds_differ", svar=svar, kind=kind, other=other, other_kind=users[other]),
            (Reason.of("rules.alias", svar=svar), Reason.of("rules.show", task=other)),
        )
        for other in standing
        if other != name and users[other] != kind
    )


def device_of(task: Task) -> str:
    """The device that its LOCAL block names; empty: none."""
    return next((line.words[0] for line in task.local if line.key == "DEVICE" and line.words), "")


def rivals(hardware: Iterable[Task]) -> dict[str, tuple[str, ...]]:
    """The devices that several tasks would move, with these."""
    users: dict[str, list[str]] = {}
    for task in hardware:
        if device_of(task):
            users.setdefault(device_of(task), []).append(task.name)
    return {device: tuple(names) for device, names in users.items() if len(names) > 1}


def claims(name: str, device: str, standing: Iterable[str]) -> tuple[Refusal, ...]:
    """Why hardware would not run beside other hardware: one device has one master."""
    return tuple(
        Refusal(
            Reason.of("rules.device_moved", device=device, other=other),
            (Reason.of("rules.replace", task=other), Reason.of("rules.show", task=other)),
        )
        for other in standing
        if other != name
    )


def _aliased(text: str, aliases: Mapping[str, str]) -> str:
    shape = Shape.parse(text)
    return str(Shape(shape.type, tuple(aliases.get(dim, dim) if isinstance(dim, str) else dim for dim in shape.dims)))
