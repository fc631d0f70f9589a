"""The front door of module authors."""

import onika.module
from onika.model.signal import Signal
from onika.runtime.modules.module import Module

NAMES = [
    "AskAgain", "Device", "GuestAction", "InBoth", "InConst", "InVar", "Input", "Local", "Module", "ModuleError",
    "OutBoth", "OutConst", "OutVar", "Partner", "Signal", "finish", "illegal", "legal", "module", "off", "shutdown",
    "user_signal",
]  # fmt: skip


def test_the_front_door_offers_exactly_these_names():  # style §3, habit 19
    """A name added or taken away here changes what every module in the world may import."""
    assert sorted(onika.module.__all__) == NAMES
    assert sorted(name for name in vars(onika.module) if not name.startswith("_")) == NAMES


def test_what_it_offers_is_what_the_runtime_uses():
    assert onika.module.Module is Module
    assert onika.module.Signal is Signal


def test_a_module_has_exactly_these_entry_points():  # R-A01
    entries = {"init", "reinit", "on", "cycle", "sync", "fileno", "off", "kill", "error", "clear", "get", "set", "hold"}
    entries |= {"take", "held"}
    calls = {"warn", "continues", "buffer", "constants", "resolve", "poses", "postures", "fits"}
    calls |= {"check_drive", "clear_drive", "state_constants"}
    names = {name for name, member in vars(Module).items() if not name.startswith("_") and hasattr(member, "__get__")}
    assert names == entries | calls
