"""Big libraries that modules and worlds use; importing them later would cost missed cycles (law 21)."""

import contextlib
import importlib

PRELOADED = ("numpy", "mujoco", "ruckig", "onika.module", "onika.laws.arm", "onika.workcell.filmed.filmed_world")


def preload() -> None:
    """Import those that are installed."""
    for name in PRELOADED:
        with contextlib.suppress(Exception):  # a module or a world that needs it will say so, and why
            importlib.import_module(name)
