"""The worlds that the flows of an application drive in place of those that its files name (requirement E09)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.desk.plan.subsystem_renaming import chiefs
from onika.model.redirect import Redirect, world_choice
from onika.wire.plan import Plan
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class RedirectableWorld:
    """A world in which a flow has devices, and which one stands for it; itself where nothing is redirected."""

    world: str
    taken_by: str


def world_seats(plan: Plan, redirects: Sequence[Redirect]) -> dict[str, tuple[RedirectableWorld, ...]]:
    """For every flow that is not nested, by its subsystem: the worlds that its files name, and who stands for each."""
    seats: dict[str, tuple[RedirectableWorld, ...]] = {}
    for home in chiefs(plan):
        chosen = world_choice(redirects, home)
        seats[home] = tuple(
            RedirectableWorld(world, chosen.get(world, world)) for world in _named(plan, Redirect("", "", home))
        )
    return seats


def homes_of(redirect: Redirect, plan: Plan) -> tuple[str, ...]:
    """The flows that are not nested and have devices in the world for which another one stands."""
    return tuple(home for home in chiefs(plan) if redirect.old[:-1] in _named(plan, Redirect("", "", home)))


def faults(redirect: Redirect, place: Place, where: Reason, plan: Plan) -> Iterator[Fault]:
    """What is wrong with the wish for another world; whether there is such a one, the runtime knows."""
    named = _named(plan, redirect)
    if redirect.old[:-1] in named:
        return
    worlds = tuple(f"{world}:" for world in named) or Reason.of("desk.no_world_named")
    unused = Reason.of("desk.world_not_of_flow", where=where, used=worlds, old=redirect.old)
    yield Fault(place, unused, NOT_RUN)


def _named(plan: Plan, extent: Redirect) -> list[str]:
    """The worlds that the tasks' files name in the flows in which a redirection holds."""
    flows = [flow for flow in plan.flows if extent.holds_in(flow.subsystem)]
    return sorted({named for flow in flows for named, _ in flow.worlds})
