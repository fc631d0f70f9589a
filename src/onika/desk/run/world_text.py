"""Which subsystem drives which world, in words, wherever there is something to tell apart (requirement E09)."""

from collections.abc import Iterator, Mapping

from onika.words.reason import Reason


def drive_lines(worlds: Mapping[str, tuple[str, ...]], simulated: Mapping[str, bool]) -> Iterator[Reason]:
    """A line for each subsystem with devices, unless all are in one world, and that is simulated.

    worlds      by subsystem
    simulated   whether each world is simulated; of others that is not known
    """
    every = {world for some in worlds.values() for world in some}
    if len(every) < 2 and all(simulated.get(world, True) for world in every):
        return
    for subsystem, some in worlds.items():
        if some:
            names = tuple(_named(world, simulated.get(world)) for world in some)
            yield Reason.of("desk.drives_worlds", subsystem=subsystem, worlds=names)


def _named(world: str, is_simulated: bool | None) -> Reason:
    if is_simulated is None:
        return Reason.plain(world)
    if is_simulated:
        return Reason.of("desk.world_simulated", world=world)
    return Reason.of("desk.world_real", world=world)
