"""What has to happen to get from the tasks there are to the tasks that are wanted (§5.3.4, Fig. 17)."""

from collections.abc import Collection, Iterable, Sequence

from msgspec import Struct

from onika.model.rules.order import Ports, constant_order


class TaskSwitch(Struct, frozen=True):
    """A switch: T1 - T2 goes off, T1 ∩ T2 is not touched, T2 - T1 comes on."""

    off: tuple[str, ...]
    keep: tuple[str, ...]
    on: tuple[str, ...]


class PlacedTask(Struct, frozen=True):
    """A task as reconfiguration sees it: its variables, its module and the device it claims."""

    ports: Ports
    module: str
    device: str | None = None

    @property
    def name(self) -> str:
        """The task's name."""
        return self.ports.name

    def excludes(self, other: "PlacedTask") -> bool:
        """Whether this one has to go before the other comes (reading 14): one name, one module, one claimed device.

        Or because it writes at every cycle what the newcomer writes at initialisation: that would break into it.
        """
        same_device = self.device is not None and self.device == other.device
        broken = set(self.ports.outvar) & set(other.ports.outconst)
        return self.name == other.name or self.module == other.module or same_device or bool(broken)


class TaskExchange(Struct, frozen=True):
    """A change of the tasks that live: who stays untouched, who dies, who is born, who learns new constants."""

    keep: tuple[str, ...]
    kill: tuple[str, ...]
    kill_first: tuple[str, ...]
    """Of `kill`: those that exclude a new task, so that they go before it comes (reading 14)."""
    spawn: tuple[str, ...]
    """In the order of constants."""
    reinit: tuple[str, ...]
    """Of `keep`: consumers of constants that come from another task now; of all: consumers of these, and so on.

    In the order of constants (requirement A13)."""


def difference(on_now: Iterable[str], wanted: Sequence[str]) -> TaskSwitch:
    """The change from `on_now` to `wanted`: `off` in the order of the former, `keep` and `on` in that of the latter."""
    before = dict.fromkeys(on_now)
    after = dict.fromkeys(wanted)
    return TaskSwitch(
        off=tuple([name for name in before if name not in after]),  # lists: every switch of a run is judged so
        keep=tuple([name for name in after if name in before]),
        on=tuple([name for name in after if name not in before]),
    )


def exchange(living: Sequence[PlacedTask], kill: Collection[str], new: Sequence[PlacedTask]) -> TaskExchange:
    """What happens to each task when `kill` goes and `new` comes; a name that is in both is exchanged."""
    keep = [placed for placed in living if placed.name not in kill]
    gone = [placed for placed in living if placed.name in kill]
    supplied = {
        svar for placed in new for svar in placed.ports.outconst
    }  # if they live at all, from one that is gone now
    born = {placed.name for placed in new}
    order, _ = constant_order([placed.ports for placed in (*keep, *new)])
    return TaskExchange(
        keep=tuple(placed.name for placed in keep),
        kill=tuple(placed.name for placed in gone),
        kill_first=tuple(placed.name for placed in gone if any(placed.excludes(other) for other in new)),
        spawn=tuple(name for name in order if name in born),
        reinit=dependents([placed.ports for placed in (*keep, *new)], supplied, born),
    )


def dependents(tasks: Sequence[Ports], constants: Collection[str], born: Collection[str] = ()) -> tuple[str, ...]:
    """Who has to be initialised anew when these constants change, at first or second hand, suppliers first.

    Those just `born` know these constants, but not yet what others say when they are initialised anew.
    """
    changed, again, dependents = set(constants), set[str](), list[str]()
    order, _ = constant_order(tasks)
    by_name = {task.name: task for task in tasks}
    for name in order:
        stale = again if name in born else again | changed
        if stale & set(by_name[name].inconst):
            dependents.append(name)
            again |= set(by_name[name].outconst)
    return tuple(dependents)
