import pytest

from onika.desk.environment.reconcile.station_names import called, station_at, station_name
from onika.desk.environment.state.model import Model
from onika.wire.view import RuntimeView


@pytest.mark.parametrize(
    ("url", "name"),
    [
        ("wss://robot.example:1", "robot"),
        ("wss://cmu.example", "cmu-2"),
        ("wss://10.0.0.7", "station"),
        ("wss://here.example", "station"),
        ("no address", "station"),
    ],
)
def test_a_station_is_called_as_its_machine_where_nobody_else_is(url, name):  # R-F02
    assert station_name(Model().with_station("cmu", RuntimeView()), url) == name


def test_a_station_is_known_by_its_address_however_that_is_written():  # R-F02
    model = Model().with_station("cmu", RuntimeView("linked", "wss://cmu.example:7994"))
    assert station_at(model, "wss://cmu.example") == "cmu"
    assert station_at(model, "wss://cmu.example:1") is None
    assert station_at(Model(), "") is None


def test_the_first_station_is_spoken_of_in_words():  # R-F02
    assert (called("cmu"), str(called(""))) == ("cmu", "the first station")
