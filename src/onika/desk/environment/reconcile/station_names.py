"""What stations are called: by the user, else by the machine on which their runtime is (requirement F02)."""

from onika.desk.environment.state.model import Model
from onika.link.starting.runtime_address import address_of
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

HERE = "here"
"""What the first station is called by whoever has to name it."""
_STATION = "station"


def station_at(model: Model, url: str) -> str | None:
    """The station whose runtime is at an address; None: none is."""
    address = _plain(url)
    stations = model.every_station.items()
    return next((name for name, runtime in stations if runtime.address and _plain(runtime.address) == address), None)


def station_name(model: Model, url: str) -> str:
    """A name for the station of a runtime at this address that no other has."""
    try:
        first = address_of(url).host.partition(".")[0]
    except ValueError:
        first = ""
    wished = first if TASK_NAME.match(first) and first != HERE else _STATION
    names = (wished, *(f"{wished}-{number}" for number in range(2, 2 + len(model.stations))))
    return next(name for name in names if name not in model.stations)


def called(station: str) -> str | Reason:
    """A station, where it is spoken of."""
    return station or Reason.of("desk.station_here")


def _plain(url: str) -> str:
    try:
        return str(address_of(url))
    except ValueError:
        return url
