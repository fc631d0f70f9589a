"""Commands as datagrams."""

import msgspec
import pytest

from onika.runtime import command
from onika.words.reason import Reason

GRANT = command.DeviceGrant("bus:w", "m0", ("time", "drive", "x"), ("force",), {"KIND": "mass", "AT": (1.0,)}, 3, 0, 64)
COMMANDS = [
    command.Spawn(
        "s", "t", "m", "m.py", "source", "periodic", 100.0, (("GAIN", ("2",)),),
        (command.BoundPort("X", "X_SIM", "double[6]", 128),), 4, 7, GRANT,
    ),
    command.Spawn("s", "t", "m", "m.py", "", "aperiodic", None, (), (), 0, 0, None),
    command.Switch("s", ("a",), ("X",), (command.Launch("b", "0.5 1", 50.0), command.Launch("c")), (("d", 40.0),)),
    command.Switch("s", (), (), (command.Launch("b", "", None, 7),)),
    command.Together((command.Switch("s", ("a",), (), ()), command.Switch("r", (), ("X",), (command.Launch("b"),)))),
    command.PreparedSwitch("s", "t", 3, (command.Case(None, True, 1, command.Switch("s", ("a",), (), ())),)),
    command.PreparedSwitch("s", "t", 3, ()),
    command.Appointment(4, 9_000, 5_000, ("s",), (command.Switch("s", ("a",), (), (command.Launch("b"),)),)),
    command.Appointment(5, 9_000, 5_000, ()),
    command.CallOff(4),
    command.CallOff(4, True),
    command.Rank("s", (("a", 1), ("b", 0))),
    command.Reinit("s", "t"),
    command.Rebind("s", "t", (command.BoundPort("X", "X_SIM", "double[7]", 256),), (("GAIN", ("3",)),)),
    command.Rebind("s", "t", ()),
    command.Swap(command.Spawn("s", "t", "m", "m.py", "", "periodic", 1.0, (), (), 0, 0, None, 3_000_000, 1_000_000)),
    command.Answer("s", "t", "1 2"),
    command.Clear("s", "t"),
    command.Get("s", "t", "progress"),
    command.Set("s", "t", "gain", "2"),
    command.Kill("s", "t"),
    command.Report(),
    command.Load(),
    command.Reset(),
    command.Stop(),
    command.Fail(Reason.plain("device server is gone")),
    command.Starve("s", "t", Reason.plain("the writer has failed")),
    command.Quit(),
]  # fmt: skip


@pytest.mark.parametrize("order", COMMANDS, ids=lambda order: type(order).__name__)
def test_a_command_arrives_as_it_was_sent(order):
    assert command.decode(command.encode(order)) == order


def test_every_command_is_among_these():
    assert {type(order) for order in COMMANDS} == set(command.Command.__args__)


@pytest.mark.parametrize("body", [b"", b"\x80", command.encode(command.Kill("s", "t"))[:-1]])
def test_what_is_no_command_is_refused(body):
    with pytest.raises(msgspec.DecodeError):
        command.decode(body)
