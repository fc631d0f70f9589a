"""The reset of worlds by request: everything back to where it stood at the start, where nothing drives it (law 18)."""

from collections.abc import Collection, Iterator
from typing import Protocol

from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.model.lifecycle import State
from onika.wire import live, request
from onika.words.reason import NOTHING, Reason, reason_of


class ResetDriver(Protocol):
    """The driver, as far as its worlds are put back."""

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds that are open."""
        ...

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        ...


class WorldReset:
    """Judges who may have a world put back, and does it."""

    def __init__(self, subsystems: Subsystems, driver: ResetDriver) -> None:
        self._subsystems = subsystems
        self._driver = driver

    def answer(self, session: str, message: live.PutBack) -> request.Response:
        """Put back what can be; of the others it is said what a person has to do. Refused, nothing has moved."""
        meant = message.worlds or self._driver.worlds
        worlds = [world for world in meant if world in self._driver.worlds]
        refusal = self._refusal(session, worlds)
        if refusal:
            return request.Refused(refusal)
        by_hand: dict[str, Reason] = {}
        for world in worlds:
            try:
                self._driver.put_back(world)
            except ValueError as why:
                by_hand[world] = reason_of(why)
        return live.WorldsPutBack(tuple(world for world in worlds if world not in by_hand), by_hand)

    def _refusal(self, session: str, worlds: Collection[str]) -> Reason:
        for run in self._subsystems.runs:
            claims = [device for name in run.names for device in run.runner.claims(name).values()]
            if _devices(claims, worlds):
                return Reason.of("host.put_back_runs", application=run.application)
        for name, subsystem in self._subsystems.live.items():
            driven = tuple(_driven(subsystem, worlds))
            if driven and subsystem.holder not in ("", session):
                return Reason.of("host.put_back_held", subsystem=name, holder=subsystem.holder)
            moving = tuple(task for task in driven if _moves(subsystem, task))
            if moving:
                return Reason.of("host.put_back_on", subsystem=name, tasks=moving)
        return NOTHING


def _driven(subsystem: LiveSubsystem, worlds: Collection[str]) -> Iterator[str]:
    """The tasks that have a device of these worlds for themselves."""
    for task, device in subsystem.executor.spawner.claims.items():
        if _devices([device], worlds):
            yield task


def _moves(subsystem: LiveSubsystem, task: str) -> bool:
    """Whether it drives its device, or is about to."""
    return subsystem.members[task].state is State.ON or subsystem.desired.is_on(task)


def _devices(claims: Collection[str], worlds: Collection[str]) -> list[str]:
    return [device for device in claims if device.partition(":")[0] in worlds]
