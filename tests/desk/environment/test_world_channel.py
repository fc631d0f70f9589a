"""Tasks that are born by hand bring the files of their worlds."""

import pytest

from kit.worlds.file_cells import CELL
from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.world_channel import WorldChannel
from onika.store.site import open_site
from onika.wire import live
from onika.wire.plan import PlannedTask


class Sent(list):
    def send(self, order):
        self.append(order.asked)


def task(device):
    return PlannedTask("arm", "arm", "", "", "rt0", None, "periodic", (), (), (), (), (), (("DEVICE", (device,)),))


@pytest.fixture
def sent(tmp_path):
    for name, text in CELL.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path, Sent()


def test_a_task_brings_the_world_of_its_device(sent):  # R-X19
    lab, orders = sent
    channel = WorldChannel(orders, open_site([lab], {}, None))
    channel.send(Order(live.Change("main", spawn=(task("cell:elbow_left"), task("cell@copy:elbow_left")))))
    assert [source.world for source in orders[0].worlds] == ["cell"]


def test_everything_else_goes_on_as_it_is(sent):
    lab, orders = sent
    channel = WorldChannel(orders, open_site([lab], {}, None))
    asked = (live.Change("main", spawn=(task("nowhere:arm_left"),)), live.Change("main", kill=("arm",)), live.Survey())
    for each in asked:
        channel.send(Order(each))
    assert tuple(orders) == asked
