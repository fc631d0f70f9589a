from types import SimpleNamespace

from onika.engine.orders import Start, Switch
from onika.host.switchboard import Switchboard
from onika.runtime import command


class Units:
    """Keeps what was sent to whom."""

    def __init__(self):
        self.sent = []

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))


def board(**homes):
    """A switchboard of one flow whose tasks live on these units."""
    members = {name: SimpleNamespace(rtpu=rtpu) for name, rtpu in homes.items()}
    units = Units()
    return Switchboard({0: SimpleNamespace(name="flow0", members=members)}, units), units


def coming(*names):
    return tuple(Start(name) for name in names)


def test_tasks_of_one_unit_switch_with_one_command():  # R-E02
    switchboard, units = board(puma="rt0", pd="rt0", jtraj="rt0")
    switchboard.put(Switch(0, ("jtraj",), coming("puma", "pd")), ("Q_REF",))
    launches = (command.Launch("puma"), command.Launch("pd"))
    assert units.sent == [("rt0", command.Switch("flow0", ("jtraj",), ("Q_REF",), launches))]


def test_a_group_on_another_unit_waits_until_the_group_before_it_is_on():  # law 3
    switchboard, units = board(puma="rt0", pd="rt1")
    switchboard.put(Switch(0, (), coming("puma", "pd")), ())
    assert [rtpu for rtpu, _ in units.sent] == ["rt0"]
    switchboard.settled(0, "puma")
    assert [rtpu for rtpu, _ in units.sent] == ["rt0", "rt1"]


def test_every_unit_turns_off_its_own_tasks_before_anything_comes_on():
    switchboard, units = board(jtraj="rt1", gripper="rt0", open="rt0")
    switchboard.put(Switch(0, ("jtraj", "gripper"), coming("open")), ())
    offs = [(rtpu, order.off) for rtpu, order in units.sent]
    assert offs == [("rt0", ("gripper",)), ("rt1", ("jtraj",)), ("rt0", ())]
    assert units.sent[-1][1].on == (command.Launch("open"),)


def test_a_rate_reaches_a_unit_on_which_nothing_goes_off():  # R-A04
    switchboard, units = board(pd="rt1", jtraj="rt0")
    switchboard.put(Switch(0, ("jtraj",), (), (("pd", 250.0),)), ())
    assert ("rt1", command.Switch("flow0", (), (), (), (("pd", 250.0),))) in units.sent


def test_a_switch_that_comes_early_begins_when_the_one_before_is_through():  # decision 16
    switchboard, units = board(puma="rt0", pd="rt1", jtraj="rt0")
    switchboard.put(Switch(0, (), coming("puma", "pd")), ())
    switchboard.put(Switch(0, ("puma",), coming("jtraj")), ())
    assert len(units.sent) == 1
    switchboard.settled(0, "puma")
    switchboard.settled(0, "pd")
    assert [order.on for _, order in units.sent] == [
        (command.Launch("puma"),),
        (command.Launch("pd"),),
        (command.Launch("jtraj"),),
    ]


def test_nothing_comes_on_in_a_flow_that_was_dropped():  # R-E07
    switchboard, units = board(puma="rt0", pd="rt1")
    switchboard.put(Switch(0, (), coming("puma", "pd")), ())
    switchboard.drop(0)
    switchboard.settled(0, "puma")
    assert len(units.sent) == 1


def test_news_of_tasks_nobody_waits_for_change_nothing():
    switchboard, units = board(puma="rt0")
    switchboard.settled(0, "puma")
    assert units.sent == []
