"""What a user does about the stations of an environment: runtimes with which it is connected (requirement F02)."""

from onika.wire.act.act import Act


class AddStation(Act, frozen=True):
    """Connect the environment with one more runtime, or with that of a station once more; the value is its name (F02).

    keeps   whether the station stays where its runtime cannot be reached, to be tried again
    """

    url: str = ""
    token: str = ""
    name: str = ""
    """Empty: made of the address."""
    keeps: bool = False


class PlaceFlow(Act, frozen=True):
    """Have a flow of an application carried out at a station while it is open; its file stays as it is (E12, F02)."""

    doc: str
    flow: str
    """The subsystem of the flow, `flow0`; empty: every flow."""
    station: str = ""


class RemoveStation(Act, frozen=True):
    """Leave the runtime of a station; what runs there goes on as its holder's loss would have it."""

    name: str
    confirmed: bool = False
