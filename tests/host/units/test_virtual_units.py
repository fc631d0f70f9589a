"""What the units say that have nothing to do with each other, though one executive carries out all of them."""

from onika.host.units.virtual_units import VirtualUnits
from onika.runtime import command, news


def units():
    return VirtualUnits(("rt1", "rt0"), {}, lambda _task: None)


def heard_of(made):
    told = []
    made.deliver(0, lambda unit, one: told.append((unit, type(one))))
    return told


def test_each_unit_that_is_asked_reports_itself():
    made = units()
    made.add("rt2")
    for name in ("rt0", "rt2"):
        made.send(name, command.Report())
    assert made.has_commands
    assert heard_of(made) == [("rt0", news.Statuses), ("rt2", news.Statuses)]
    assert not made.has_commands


def test_what_all_are_told_is_told_to_each_in_the_order_of_their_names():
    made = units()
    made.send_all(command.Report())
    assert [name for name, _ in heard_of(made)] == ["rt0", "rt1"]


def test_news_of_a_task_is_its_units():
    made, told = units(), []
    made.homes["s0", "lamp"] = "rt1"
    made.tell([news.Changed("s0", "lamp", "OFF", 0)], lambda unit, _one: told.append(unit))
    made.tell([news.Changed("s0", "door", "OFF", 0)], lambda unit, _one: told.append(unit))
    assert told == ["rt1", ""]
