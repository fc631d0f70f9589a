"""Sources of small modules for tests: a class called One with the flags and the body that are given."""

HEAD = """
import sys
from onika.model.signal import Signal, SignalKind
from onika.module import *
from onika.module import AskAgain, Device, InBoth, InConst, InVar, Input, Local, Module, ModuleError
from onika.module import OutBoth, OutConst, OutVar
"""
"""What every such source begins with."""


def module(body: str = "    pass", **flags: object) -> str:
    """The source of a module with this body, indented as in a class, and these class attributes."""
    lines = "\n".join(f"    {name} = {value!r}" for name, value in flags.items())
    return f"{HEAD}\nclass One(Module):\n{lines}\n{body}\n"


def cycle(line: str, **flags: object) -> str:
    """The source of a module whose cycle is one line."""
    return module(f"    def cycle(self):\n        {line}", **flags)


COUNTER = module("    N = OutVar('int')\n    def cycle(self):\n        self.N += 1")
"""Counts its cycles."""
