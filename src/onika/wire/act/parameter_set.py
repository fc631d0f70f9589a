"""What a user does to the parameter sets of a configuration; each is replied with `view.ParameterSetsView`."""

from onika.wire.act.act import Act


class ListSets(Act, frozen=True):
    """Ask for the parameter sets of a configuration, and for its parameters as they are now."""

    doc: str


class KeepSet(Act, frozen=True):
    """Keep the parameters of the tasks of a configuration as they are now, under a name."""

    doc: str
    name: str
    overwrites: bool = False


class SwitchSet(Act, frozen=True):
    """Take all values of a set over, or none: where one is refused nothing changes."""

    doc: str
    name: str


class RemoveSet(Act, frozen=True):
    """Keep a set no longer."""

    doc: str
    name: str
