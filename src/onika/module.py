"""The front door of module authors: everything a control module imports from Onika, and nothing else."""

from onika.model.signal import Signal, finish, illegal, legal, off, shutdown, user_signal
from onika.runtime.declaration import InBoth, InConst, Input, InVar, Local, OutBoth, OutConst, OutVar
from onika.runtime.device import Device
from onika.runtime.error import AskAgain, ModuleError
from onika.runtime.modules.function import module
from onika.runtime.modules.guest_action import GuestAction
from onika.runtime.modules.module import Module
from onika.runtime.partner.partner import Partner

__all__ = [
    "AskAgain",
    "Device",
    "GuestAction",
    "InBoth",
    "InConst",
    "InVar",
    "Input",
    "Local",
    "Module",
    "ModuleError",
    "OutBoth",
    "OutConst",
    "OutVar",
    "Partner",
    "Signal",
    "finish",
    "illegal",
    "legal",
    "module",
    "off",
    "shutdown",
    "user_signal",
]
